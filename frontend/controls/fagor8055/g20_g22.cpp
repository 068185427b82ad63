// G20 to G22: work zones (8055 T 3.8).
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using program::WorkZone;

template <WorkZone::Kind kind>
constexpr auto zone = +[]() -> program::Function {
    return WorkZone{.kind = kind, .zone = {}, .state = {}, .limits = {}};
};

constexpr Operand number{.address = 'K',
                         .role = Role::row,
                         .need = Need::required,
                         .range = {.least = 1, .most = 4, .whole = true},
                         .slot = at<&WorkZone::zone>,
                         .text = {"work zone", "zone de travail", "zona de trabajo"}};

constexpr Operand limit_operands[] = {
    number,
    {.address = any_axis,
     .role = Role::machine_coordinate,
     .need = Need::required,
     .slot = at<&WorkZone::limits>,
     .text = {"limit, machine coordinate, X as a radius", "limite, cote machine, X au rayon",
              "límite, cota máquina, X en radios"}}};

constexpr Operand state_operands[] = {
    number,
    {.address = 'S',
     .role = Role::choice,
     .need = Need::required,
     .range = {.least = 0, .most = 2, .whole = true},
     .slot = at<&WorkZone::state>,
     .text = {"0 off, 1 no entry, 2 no exit", "0 désactivée, 1 non-entrée, 2 non-sortie",
              "0 desactivada, 1 no entrada, 2 no salida"}}};

}  // namespace

constexpr Construct g20{.number = 20,
                        .code = "G20",
                        .support = Support::planned,
                        .company = Company::alone_expected,
                        .takes = Takes::listed,
                        .syntax = "G20 K1..4 X..C5.5",
                        .snippet = "G20 K1 X20 Z20",
                        .section = "8055 T 3.8.1",
                        .title = {"lower limits of a work zone", "limites inférieures de zone de travail",
                                  "límites inferiores de zona de trabajo"},
                        .operands = limit_operands,
                        .make = zone<WorkZone::Kind::lower>,
                        .target = target_of<WorkZone>,
                        .out_of_range = diag::Id::zone_out_of_range};

constexpr Construct g21{.number = 21,
                        .code = "G21",
                        .support = Support::planned,
                        .company = Company::alone_expected,
                        .takes = Takes::listed,
                        .syntax = "G21 K1..4 X..C5.5",
                        .snippet = "G21 K1 X50 Z100",
                        .section = "8055 T 3.8.1",
                        .title = {"upper limits of a work zone", "limites supérieures de zone de travail",
                                  "límites superiores de zona de trabajo"},
                        .operands = limit_operands,
                        .make = zone<WorkZone::Kind::upper>,
                        .target = target_of<WorkZone>,
                        .out_of_range = diag::Id::zone_out_of_range};

constexpr Construct g22{.number = 22,
                        .code = "G22",
                        .support = Support::planned,
                        .company = Company::alone_expected,
                        .takes = Takes::listed,
                        .syntax = "G22 K1..4 S0..2",
                        .snippet = "G22 K1 S1",
                        .section = "8055 T 3.8.2",
                        .title = {"work zone on, off", "validation ou invalidation de zone de travail",
                                  "habilitación o inhabilitación de zona de trabajo"},
                        .operands = state_operands,
                        .make = zone<WorkZone::Kind::state>,
                        .target = target_of<WorkZone>,
                        .misuse = diag::Id::zone_state_operands,
                        .out_of_range = diag::Id::zone_out_of_range};

static_assert(well_formed(g20) && well_formed(g21) && well_formed(g22));

}  // namespace fagorc::frontend::fagor8055
