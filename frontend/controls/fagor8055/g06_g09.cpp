// G06 G08 G09: arcs by absolute centre, by tangency, through a point (8055 T 6.4 to 6.6).
#include "frontend/controls/fagor8055/operands.hpp"
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

constexpr Operand centre_operands[] = {
    {.address = 'I',
     .role = Role::centre_point,
     .text = {"centre along X, U or A, absolute, as a coordinate", "centre suivant X, U ou A, en cote absolue",
              "centro según X, U o A, en cota absoluta"}},
    {.address = 'J',
     .role = Role::centre_point,
     .text = {"centre along Y, V or B, absolute", "centre suivant Y, V ou B, en cote absolue",
              "centro según Y, V o B, en cota absoluta"}},
    {.address = 'K',
     .role = Role::centre_point,
     .text = {"centre along Z, W or C, absolute", "centre suivant Z, W ou C, en cote absolue",
              "centro según Z, W o C, en cota absoluta"}}};

constexpr Operand tangent_operands[] = {end_point, polar_radius, polar_angle};

constexpr Operand three_point_operands[] = {
    end_point,
    polar_radius,
    polar_angle,
    {.address = 'I',
     .role = Role::centre_point,
     .text = {"point of the arc along X, U or A, as a coordinate", "point de l'arc suivant X, U ou A, en cote",
              "punto del arco según X, U o A, en cota"}},
    {.address = 'J',
     .role = Role::centre_point,
     .text = {"point of the arc along Y, V or B", "point de l'arc suivant Y, V ou B", "punto del arco según Y, V o B"}},
    {.address = 'K',
     .role = Role::centre_point,
     .text = {"point of the arc along Z, W or C", "point de l'arc suivant Z, W ou C",
              "punto del arco según Z, W o C"}}};

}  // namespace

constexpr Construct g06{
    .number = 6,
    .code = "G06",
    .takes = Takes::motion,
    .syntax = "G06 G02|G03 X..C5.5 I6.5 J6.5 K6.5",
    .snippet = "G00 X80 Z60\nG06 G03 X180 Z110 I180 K60 F100",
    .section = "8055 T 6.4",
    .title = {"centre of the arc in absolute coordinates", "centre de l'arc en coordonnées absolues",
              "centro del arco en coordenadas absolutas"},
    .operands = centre_operands,
    .make = makes<program::AbsoluteCentre>,
    .target = target_of<program::AbsoluteCentre>};

constexpr Construct g08{
    .number = 8,
    .code = "G08",
    .takes = Takes::motion,
    .syntax = "G08 X..C5.5 | G08 R5.5 Q5.5",
    .snippet = "G01 X0 Z270 F100\nX100 Z250\nG08 X120 Z180",
    .section = "8055 T 6.5",
    .title = {"arc tangent to the previous path", "trajectoire circulaire tangente à la trajectoire précédente",
              "trayectoria circular tangente a la trayectoria anterior"},
    .operands = tangent_operands,
    .make = makes<program::TangentArc>,
    .target = target_of<program::TangentArc>};

constexpr Construct g09{.number = 9,
                        .code = "G09",
                        .takes = Takes::motion,
                        .syntax = "G09 X..C5.5 I5.5 J5.5 K5.5 | G09 R5.5 Q5.5 I5.5 J5.5 K5.5",
                        .snippet = "G00 X60 Z70\nG09 X120 Z20 I60 K50 F100",
                        .section = "8055 T 6.6",
                        .title = {"arc through three points", "trajectoire circulaire définie par trois points",
                                  "trayectoria circular definida por tres puntos"},
                        .operands = three_point_operands,
                        .make = makes<program::ThreePointArc>,
                        .target = target_of<program::ThreePointArc>};

static_assert(well_formed(g06) && well_formed(g08) && well_formed(g09));

}  // namespace fagorc::frontend::fagor8055
