// G70 G71, G90 G91, G151 G152: how coordinates are written (8055 T 3.3 to 3.5).
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

constexpr Construct g70{.number = 70,
                        .code = "G70",
                        .group = Group::unit,
                        .setting = setting(program::LengthUnit::inch),
                        .syntax = "G70",
                        .snippet = "G70 G01 X1.5 F10",
                        .section = "8055 T 3.3",
                        .title = {"programming in inches", "programmation en pouces", "programación en pulgadas"}};

constexpr Construct g71{
    .number = 71,
    .code = "G71",
    .group = Group::unit,
    .setting = setting(program::LengthUnit::mm),
    .syntax = "G71",
    .snippet = "G71 G01 X15 F100",
    .section = "8055 T 3.3",
    .title = {"programming in millimetres", "programmation en millimètres", "programación en milímetros"}};

constexpr Construct g90{.number = 90,
                        .code = "G90",
                        .group = Group::distance,
                        .setting = setting(program::Distance::absolute),
                        .syntax = "G90",
                        .snippet = "G90 G01 X20 Z60 F100",
                        .section = "8055 T 3.4",
                        .title = {"absolute coordinates", "coordonnées absolues", "coordenadas absolutas"}};

constexpr Construct g91{.number = 91,
                        .code = "G91",
                        .group = Group::distance,
                        .setting = setting(program::Distance::incremental),
                        .syntax = "G91",
                        .snippet = "G91 G01 X-40 F100",
                        .section = "8055 T 3.4",
                        .title = {"incremental coordinates", "coordonnées incrémentales", "coordenadas incrementales"}};

constexpr Construct g151{.number = 151,
                         .code = "G151",
                         .group = Group::diameter,
                         .setting = setting(program::XWord::diameter),
                         .syntax = "G151",
                         .snippet = "G151 G01 X40 F100",
                         .section = "8055 T 3.5",
                         .title = {"X in diameters", "cotes X au diamètre", "cotas X en diámetros"}};

constexpr Construct g152{.number = 152,
                         .code = "G152",
                         .group = Group::diameter,
                         .setting = setting(program::XWord::radius),
                         .syntax = "G152",
                         .snippet = "G152 G01 X20 F100",
                         .section = "8055 T 3.5",
                         .title = {"X in radii", "cotes X au rayon", "cotas X en radios"}};

static_assert(well_formed(g70) && well_formed(g71) && well_formed(g90) && well_formed(g91) && well_formed(g151) &&
              well_formed(g152));

}  // namespace fagorc::frontend::fagor8055
