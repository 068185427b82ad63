// G88 G89: grooving along X and along Z (8055 T 9.11, 9.12).
#include "frontend/controls/fagor8055/cycle_operands.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using Cycle = operation::Grooving;
using operation::Cut;

constexpr Operand operands[] = {start_x<Cycle>,
                                start_z<Cycle>,
                                end_x<Cycle>,
                                end_z<Cycle>,
                                {.address = 'C',
                                 .role = Role::length,
                                 .range = positive,
                                 .slot = at<&Cycle::step>,
                                 .text = {"step between plunges; none: the width of the insert",
                                          "pas entre pénétrations ; absent : largeur de la plaquette",
                                          "paso entre penetraciones; ausente: anchura de la plaquita"}},
                                {.address = 'D',
                                 .role = Role::length,
                                 .range = not_negative,
                                 .slot = at<&Cycle::clearance>,
                                 .text = {"safety distance from the surface", "distance de sécurité à la surface",
                                          "distancia de seguridad a la superficie"}},
                                dwell<Cycle>};

}  // namespace

constexpr Construct g88 =
    cycle<Cycle>(88, "G88", "8055 T 9.11",
                 {"grooving along X", "cycle fixe de rainurage sur l'axe X", "ciclo fijo de ranurado en el eje X"},
                 "G88 X5.5 Z5.5 Q5.5 R5.5 [C5.5] [D5.5] [K5]", "G00 X60 Z2\nG88 X40 Z-20 Q30 R-32 D2", operands,
                 cutting<Cycle, Cut::along_v>);
constexpr Construct g89 =
    cycle<Cycle>(89, "G89", "8055 T 9.12",
                 {"grooving along Z", "cycle fixe de rainurage sur l'axe Z", "ciclo fijo de ranurado en el eje Z"},
                 "G89 X5.5 Z5.5 Q5.5 R5.5 [C5.5] [D5.5] [K5]", "G00 X80 Z5\nG89 X60 Z0 Q44 R-6 D1", operands,
                 cutting<Cycle, Cut::along_u>);

static_assert(well_formed(g88) && well_formed(g89));

}  // namespace fagorc::frontend::fagor8055
