// G00 to G03: rapid, line, arcs (8055 T 6.1 to 6.3).
#include "frontend/controls/fagor8055/operands.hpp"
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

constexpr Operand line_operands[] = {
    end_point,
    polar_radius,
    {.address = 'Q',
     .role = Role::angle,
     .text = {"polar angle of the end point; with one coordinate of the plane: angle of the path with the abscissa",
              "angle polaire du point d'arrivée ; avec une seule cote du plan : angle de la trajectoire avec l'axe "
              "d'abscisses",
              "ángulo polar del punto final; con una sola cota del plano: ángulo de la trayectoria con el eje de "
              "abscisas"}}};

constexpr Operand arc_operands[] = {
    end_point,
    {.address = 'I',
     .role = Role::centre,
     .text = {"centre along X, U or A, from the start point, as a radius",
              "centre suivant X, U ou A, depuis le point de départ, au rayon",
              "centro según X, U o A, desde el punto inicial, en radios"}},
    {.address = 'J',
     .role = Role::centre,
     .text = {"centre along Y, V or B, from the start point", "centre suivant Y, V ou B, depuis le point de départ",
              "centro según Y, V o B, desde el punto inicial"}},
    {.address = 'K',
     .role = Role::centre,
     .text = {"centre along Z, W or C, from the start point", "centre suivant Z, W ou C, depuis le point de départ",
              "centro según Z, W o C, desde el punto inicial"}},
    {.address = 'R',
     .role = Role::length,
     .text = {"radius of the arc; negative for an arc of more than 180 degrees",
              "rayon de l'arc ; négatif pour un arc de plus de 180 degrés",
              "radio del arco; negativo para un arco de más de 180 grados"}},
    {.address = 'Q',
     .role = Role::angle,
     .text = {"angle of the end point seen from the centre", "angle du point d'arrivée vu depuis le centre",
              "ángulo del punto final visto desde el centro"}}};

}  // namespace

constexpr Construct g00{.number = 0,
                        .code = "G00",
                        .group = Group::motion,
                        .setting = setting(program::Motion::rapid),
                        .takes = Takes::motion,
                        .syntax = "G00 X..C5.5 | G00 R5.5 Q5.5",
                        .snippet = "G00 X300 Z400",
                        .section = "8055 T 6.1",
                        .title = {"rapid positioning", "positionnement rapide", "posicionamiento rápido"},
                        .operands = line_operands};

constexpr Construct g01{.number = 1,
                        .code = "G01",
                        .group = Group::motion,
                        .setting = setting(program::Motion::line),
                        .takes = Takes::motion,
                        .syntax = "G01 X..C5.5 | G01 R5.5 Q5.5 | G01 Q5.5 X5.5",
                        .snippet = "G01 X80 Z65 F150",
                        .section = "8055 T 6.2",
                        .title = {"linear interpolation", "interpolation linéaire", "interpolación lineal"},
                        .operands = line_operands};

constexpr Construct g02{
    .number = 2,
    .code = "G02",
    .group = Group::motion,
    .setting = setting(program::Motion::cw),
    .takes = Takes::motion,
    .syntax = "G02 X..C5.5 I6.5 J6.5 K6.5 | G02 X..C5.5 R6.5 | G02 Q5.5 [I6.5 J6.5 K6.5]",
    .snippet = "G00 X20 Z50\nG02 X60 Z30 I20 K0 F100",
    .section = "8055 T 6.3",
    .title = {"circular interpolation, clockwise", "interpolation circulaire à droite (sens horaire)",
              "interpolación circular a derechas (horaria)"},
    .operands = arc_operands};

constexpr Construct g03{
    .number = 3,
    .code = "G03",
    .group = Group::motion,
    .setting = setting(program::Motion::ccw),
    .takes = Takes::motion,
    .syntax = "G03 X..C5.5 I6.5 J6.5 K6.5 | G03 X..C5.5 R6.5 | G03 Q5.5 [I6.5 J6.5 K6.5]",
    .snippet = "G00 X80 Z60\nG03 X180 Z110 I50 K0 F100",
    .section = "8055 T 6.3",
    .title = {"circular interpolation, counter-clockwise", "interpolation circulaire à gauche (sens antihoraire)",
              "interpolación circular a izquierdas (antihoraria)"},
    .operands = arc_operands};

static_assert(well_formed(g00) && well_formed(g01) && well_formed(g02) && well_formed(g03));

}  // namespace fagorc::frontend::fagor8055
