// G40 to G42: tool radius compensation (8055 T 8.2).
#include "frontend/controls/fagor8055/operands.hpp"
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

constexpr Construct g40{.number = 40,
                        .code = "G40",
                        .group = Group::compensation,
                        .setting = setting(program::Side::off),
                        .syntax = "G40",
                        .snippet = "G40 X110 Z100",
                        .section = "8055 T 8.2.6",
                        .title = {"tool radius compensation off", "annulation de la compensation de rayon d'outil",
                                  "anulación de la compensación de radio de herramienta"}};
static_assert(well_formed(g40));

}  // namespace fagorc::frontend::fagor8055
