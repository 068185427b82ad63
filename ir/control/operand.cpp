#include "ir/control/operand.hpp"

#include <fmt/format.h>

#include <cmath>

namespace fagorc::control {

std::string to_string(const Range& range) {
    const bool low = std::isfinite(range.least), high = std::isfinite(range.most);
    if (low && high) return fmt::format("{} .. {}", range.least, range.most);
    if (low) return fmt::format("{} {}", range.above ? ">" : ">=", range.least);
    if (range.not_zero) return "<> 0";
    return high ? fmt::format("<= {}", range.most) : std::string();
}

}  // namespace fagorc::control
