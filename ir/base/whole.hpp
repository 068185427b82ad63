// Whole numbers behind values: those that name a parameter, a label, a subroutine, or count something.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>

namespace fagorc {

/// The whole number that a value stands for, from 0 to 2^32 - 2; nothing where the value is not one, is further from
/// one than `tolerance`, or is not in that range.
inline std::optional<std::uint32_t> whole_number(double value, double tolerance = 0) {
    if (!(value > -1 && value < 4294967294.5)) return std::nullopt;
    const auto nearest = static_cast<std::uint32_t>(value + 0.5);
    return std::abs(value - nearest) <= tolerance ? std::optional(nearest) : std::nullopt;
}

}  // namespace fagorc
