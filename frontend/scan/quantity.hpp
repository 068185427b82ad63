// Reads the digits of a number.
#pragma once

#include <cstddef>

#include "ir/program/token.hpp"

namespace fagorc::frontend {

constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\0';
}
/// The value of a digit; 10 or more for what is none.
constexpr unsigned digit_value(char c) {
    return static_cast<unsigned char>(c) - unsigned{'0'};
}

/// Up to so many digits an integer is exact in a double, and so is the divisor: one division rounds correctly.
inline constexpr std::ptrdiff_t exact_digits = 15;
inline constexpr double powers_of_ten[exact_digits + 1] = {1e0, 1e1, 1e2,  1e3,  1e4,  1e5,  1e6,  1e7,
                                                           1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};

/// A number with blanks or with more digits than one division rounds correctly: rare, so the library reads it.
const char* read_long_quantity(const char* p, bool negative, program::Quantity& q);
/// Whether a number goes on behind the blanks at `p`; `point`: it has its point.
inline bool goes_on(const char* p, bool point) {
    while (is_blank(*p)) ++p;
    return digit_value(*p) < 10 || (*p == '.' && !point);
}

/// Reads digits and a point from `p`; blanks between them mean nothing (8055 T 2: `X 3 0` is X30). Sets value,
/// correctly rounded, and digit counts of `q`, not its place. Returns the place behind the last digit; `p`
/// where there is no digit. In the header because every word of every block comes through it.
inline const char* read_quantity(const char* p, bool negative, program::Quantity& q) {
    const char* const from = p;
    while (*p == '0') ++p;
    const char* const first = p;
    std::uint64_t mantissa = 0;
    for (unsigned d; (d = digit_value(*p)) < 10; ++p) mantissa = mantissa * 10 + d;
    const std::ptrdiff_t integer = p - first;
    const bool point = *p == '.';
    std::ptrdiff_t decimals = 0;
    if (point) {
        const char* const begin = ++p;
        for (unsigned d; (d = digit_value(*p)) < 10; ++p) mantissa = mantissa * 10 + d;
        decimals = p - begin;
    }
    if (p - first > exact_digits || (is_blank(*p) && goes_on(p, point))) [[unlikely]]
        return read_long_quantity(from, negative, q);
    if (p - from == point) [[unlikely]]
        return from;
    // Fifteen digits fit a signed integer, which the processor converts in one step.
    double value = static_cast<double>(static_cast<std::int64_t>(mantissa));
    if (decimals) value /= powers_of_ten[decimals];
    q.value = negative ? 0.0 - value : value;  // the sign of nothing is plus
    q.integer_digits = static_cast<std::uint8_t>(integer);
    q.decimals = static_cast<std::uint8_t>(decimals) & 0x7f;
    q.hexadecimal = 0;
    return p;
}

}  // namespace fagorc::frontend
