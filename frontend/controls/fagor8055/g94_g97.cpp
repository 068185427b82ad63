// G94 to G97: what F and S mean (8055 T 5.2, 5.3).
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

constexpr Construct g94{
    .number = 94,
    .code = "G94",
    .group = Group::feed,
    .setting = setting(program::FeedMode::per_minute),
    .syntax = "G94",
    .snippet = "G94 G01 X10 F150",
    .section = "8055 T 5.2.1",
    .title = {"feed in millimetres (inches) per minute", "avance en millimètres (pouces) par minute",
              "avance en milímetros (pulgadas) por minuto"}};

constexpr Construct g95{
    .number = 95,
    .code = "G95",
    .group = Group::feed,
    .setting = setting(program::FeedMode::per_revolution),
    .syntax = "G95",
    .snippet = "S500 M03\nG95 G01 X10 F0.2",
    .section = "8055 T 5.2.2",
    .title = {"feed in millimetres (inches) per revolution", "avance en millimètres (pouces) par tour",
              "avance en milímetros (pulgadas) por revolución"}};

constexpr Construct g96{
    .number = 96,
    .code = "G96",
    .group = Group::speed,
    .setting = setting(program::SpeedMode::constant_surface),
    .syntax = "G96 [S5.4]",
    .snippet = "G96 S150 M03",
    .section = "8055 T 5.3.1",
    .title = {"constant surface speed", "vitesse de coupe constante", "velocidad de corte constante"}};

constexpr Construct g97{
    .number = 97,
    .code = "G97",
    .group = Group::speed,
    .setting = setting(program::SpeedMode::rpm),
    .syntax = "G97 [S5.4]",
    .snippet = "G97 S800 M03",
    .section = "8055 T 5.3.2",
    .title = {"spindle speed in rpm", "vitesse de broche en tr/min", "velocidad de giro del cabezal en r.p.m."}};

static_assert(well_formed(g94) && well_formed(g95) && well_formed(g96) && well_formed(g97));

}  // namespace fagorc::frontend::fagor8055
