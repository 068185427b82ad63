// G15: the main spindle as C axis (8055 T 6.15).
#include "frontend/controls/fagor8055/operands.hpp"
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

constexpr Operand operands[] = {{.address = 'R',
                                 .role = Role::length,
                                 .range = positive,
                                 .slot = at<&program::RotaryPlane::radius>,
                                 .text = {"radius of the cylinder to develop", "rayon du cylindre à développer",
                                          "radio del cilindro que se desarrolla"}}};

}  // namespace

constexpr Construct g15{.number = 15,
                        .code = "G15",
                        .lasts = true,
                        .support = Support::planned,
                        .company = Company::alone,
                        .takes = Takes::listed,
                        .syntax = "G15 [R5.5]",
                        .snippet = "G15 R20",
                        .section = "8055 T 6.15",
                        .title = {"C axis", "activation de l'axe C", "activación del eje C"},
                        .operands = operands,
                        .make = makes<program::RotaryPlane>,
                        .target = target_of<program::RotaryPlane>};
static_assert(well_formed(g15));

}  // namespace fagorc::frontend::fagor8055
