// G04: dwell and stop of block preparation (8055 T 7.1).
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

constexpr Operand operands[] = {
    {.address = 'K',
     .role = Role::hundredths,
     .range = {.least = 0, .most = 99999, .whole = true},
     .slot = at<&program::Dwell::hundredths>,
     .text = {
         "time in hundredths of a second; 0 or no value: stop of block preparation that takes the real position",
         "temps en centièmes de seconde ; 0 ou sans valeur : arrêt de la préparation de blocs avec prise de la cote "
         "réelle",
         "tiempo en centésimas de segundo; 0 o sin valor: parada de la preparación de bloques y toma de la cota "
         "real"}}};

}  // namespace

constexpr Construct g04{.number = 4,
                        .code = "G04",
                        .company = Company::alone_without_operands,
                        .takes = Takes::next,
                        .syntax = "G04 | G04 K0 | G04 K1..99999",
                        .snippet = "G04 K50",
                        .section = "8055 T 7.1",
                        .title = {"dwell, stop of block preparation", "temporisation, arrêt de la préparation de blocs",
                                  "temporización, detención de la preparación de bloques"},
                        .operands = operands,
                        .make = makes<program::Dwell>,
                        .target = target_of<program::Dwell>};
static_assert(well_formed(g04));

}  // namespace fagorc::frontend::fagor8055
