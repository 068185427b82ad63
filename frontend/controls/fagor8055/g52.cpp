// G52: move to a hard stop (8055 T 6.16).
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

constexpr Operand operands[] = {
    {.address = any_axis,
     .role = Role::coordinate,
     .need = Need::required,
     .slot = at<&program::HardStop::axes>,
     .text = {"coordinate beyond the stop", "cote au-delà de la butée", "cota más allá del tope"}}};

}  // namespace

constexpr Construct g52{.number = 52,
                        .code = "G52",
                        .support = Support::planned,
                        .takes = Takes::listed,
                        .syntax = "G52 X..C5.5",
                        .snippet = "G01 F100\nG52 X10",
                        .section = "8055 T 6.16",
                        .title = {"move to a hard stop", "déplacement contre butée", "movimiento contra tope"},
                        .operands = operands,
                        .make = makes<program::HardStop>,
                        .target = target_of<program::HardStop>,
                        .least_axes = 1,
                        .most_axes = 1,
                        .misuse = diag::Id::hard_stop_axis};
static_assert(well_formed(g52));

}  // namespace fagorc::frontend::fagor8055
