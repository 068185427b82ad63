// G46: angular transformation of an inclined axis (8055 T 13).
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

constexpr Operand operands[] = {
    {.address = 'S',
     .role = Role::choice,
     .range = {.least = 0, .most = 2, .whole = true},
     .slot = at<&program::InclinedAxis::state>,
     .text = {"0 or none: off, 1: on, 2: frozen", "0 ou absent : désactivée, 1 : activée, 2 : bloquée",
              "0 o ausente: desactivada, 1: activada, 2: congelada"}}};

}  // namespace

constexpr Construct g46{
    .number = 46,
    .code = "G46",
    .lasts = true,
    .support = Support::planned,
    .company = Company::alone_expected,
    .takes = Takes::listed,
    .syntax = "G46 [S0..2]",
    .snippet = "G46 S1\nG01 X10 F100\nG46",
    .section = "8055 T 13.1",
    .title = {"inclined axis", "transformation angulaire de l'axe incliné", "transformación angular del eje inclinado"},
    .operands = operands,
    .make = makes<program::InclinedAxis>,
    .target = target_of<program::InclinedAxis>};
static_assert(well_formed(g46));

}  // namespace fagorc::frontend::fagor8055
