// Shape keys as people read them.
#pragma once

#include <string>
#include <string_view>

#include "ir/control/dialect.hpp"

namespace fagorc::frontend {

/// The tokens of a key with blanks between: `N # G1 X # Z # F #`, `( IF P # EQ # GOTO N # )`. Quantities are `#`, texts
/// `$`.
std::string readable_key(std::string_view key, const control::Dialect& dialect);

}  // namespace fagorc::frontend
