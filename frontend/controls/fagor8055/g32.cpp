// G32: feed as the inverse of time (8055 T 6.17).
#include "frontend/controls/fagor8055/rows.hpp"

namespace fagorc::frontend::fagor8055 {

constexpr Construct g32{.number = 32,
                        .code = "G32",
                        .group = Group::feed,
                        .setting = setting(program::FeedMode::inverse_time),
                        .support = Support::planned,
                        .syntax = "G32",
                        .snippet = "G32 G01 X22 F4\nG94",
                        .section = "8055 T 6.17",
                        .title = {"feed as the inverse of time", "avance F comme fonction inverse du temps",
                                  "avance F como función inversa del tiempo"}};
static_assert(well_formed(g32));

}  // namespace fagorc::frontend::fagor8055
