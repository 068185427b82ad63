// The version of the program, from the project's CMakeLists.txt.
#pragma once

namespace fagorc::tool {

inline constexpr const char* version = FAGORC_VERSION;

}  // namespace fagorc::tool
