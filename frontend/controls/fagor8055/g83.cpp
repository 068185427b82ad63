// G83: axial drilling and tapping (8055 T 9.6).
#include "frontend/controls/fagor8055/drilling_operands.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using Cycle = operation::PeckDrilling;

constexpr Operand operands[] = {start_x<Cycle>,
                                start_z<Cycle>,
                                {.address = 'I',
                                 .role = Role::distance_u,
                                 .need = Need::required,
                                 .range = not_zero,
                                 .slot = at<&Cycle::depth>,
                                 .text = {"depth from Z, positive towards -Z", "profondeur depuis Z, positive vers -Z",
                                          "profundidad desde Z, positiva hacia -Z"}},
                                peck<Cycle>,
                                approach<Cycle>,
                                dwell<Cycle>,
                                lift<Cycle>,
                                clearance<Cycle>,
                                least_peck<Cycle>,
                                peck_factor<Cycle>};

}  // namespace

constexpr Construct g83 = cycle<Cycle>(83, "G83", "8055 T 9.6",
                                       {"axial drilling, tapping", "cycle fixe de perçage axial, taraudage",
                                        "ciclo fijo de taladrado axial, roscado con macho"},
                                       "G83 X5.5 Z5.5 I5.5 B5.5 [D5.5] [K5] [H5.5] [C5.5] [L5.5] [R5.5]",
                                       "G00 X0 Z10\nG83 X0 Z0 I40 B15 D2 K50", operands);
static_assert(well_formed(g83));

}  // namespace fagorc::frontend::fagor8055
