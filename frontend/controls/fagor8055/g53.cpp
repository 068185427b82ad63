// G53: machine coordinates (8055 T 4.3).
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

constexpr Construct g53{.number = 53,
                        .code = "G53",
                        .syntax = "G53 | G53 X..C5.5",
                        .snippet = "G53 G00 X140 Z100",
                        .section = "8055 T 4.3",
                        .title = {"programming with respect to machine zero",
                                  "programmation par rapport au zéro machine", "programación respecto al cero máquina"},
                        .make = makes<program::MachineCoordinates>,
                        .target = target_of<program::MachineCoordinates>};
static_assert(well_formed(g53));

}  // namespace fagorc::frontend::fagor8055
