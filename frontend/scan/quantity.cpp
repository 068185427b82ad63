#include "frontend/scan/quantity.hpp"

#include <algorithm>
#include <charconv>
#include <string>

namespace fagorc::frontend {
namespace {

constexpr double powers[] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15};
/// Up to so many digits an integer is exact in a double, and so is the divisor: one division rounds correctly.
constexpr std::ptrdiff_t exact_digits = 15;

constexpr bool is_digit(char c) {
    return static_cast<unsigned char>(c - '0') < 10;
}
constexpr bool is_blank(char c) {
    return c == ' ' || c == '\t' || c == '\0';
}

/// Whether the number goes on behind blanks at `p`.
bool goes_on(const char* p, bool point) {
    while (is_blank(*p)) ++p;
    return is_digit(*p) || (*p == '.' && !point);
}

/// A quantity without its place. The sign of nothing is plus.
program::Quantity quantity(double value, bool negative, std::ptrdiff_t integer, std::ptrdiff_t decimals) {
    program::Quantity q;
    q.value = negative ? 0.0 - value : value;
    q.integer_digits = static_cast<std::uint8_t>(integer);
    q.decimals = static_cast<std::uint8_t>(decimals) & 0x7f;
    return q;
}

/// A number with blanks or with more digits than one division rounds correctly: rare, so the library reads it.
const char* read_long(const char* p, bool negative, program::Quantity& q) {
    std::string digits;
    std::ptrdiff_t integer = 0, decimals = 0;
    bool point = false;
    const char* to = p;
    for (;; ++p) {
        if (is_blank(*p)) continue;
        const bool digit = is_digit(*p);
        if (!digit && (*p != '.' || point)) break;
        point = point || !digit;
        digits += *p;
        to = p + 1;
        if (digit && point)
            ++decimals;
        else if (digit)
            integer += integer || *p != '0';
    }
    double value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    q = quantity(value, negative, std::min<std::ptrdiff_t>(integer, 255), std::min<std::ptrdiff_t>(decimals, 127));
    return to;
}

}  // namespace

const char* read_quantity(const char* p, bool negative, program::Quantity& q) {
    const char* const from = p;
    std::uint64_t mantissa = 0;
    while (*p == '0') ++p;
    const char* const first = p;
    for (; is_digit(*p); ++p) mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p - '0');
    const std::ptrdiff_t integer = p - first;
    const bool point = *p == '.';
    const char* const decimals = p + point;
    for (p = decimals; is_digit(*p); ++p) mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p - '0');
    const bool digits = p - from > point;
    if ((is_blank(*p) && goes_on(p, point)) || p - first > exact_digits) return read_long(from, negative, q);
    if (!digits) return from;
    // Fifteen digits fit a signed integer, which the processor converts in one step.
    const double value = static_cast<double>(static_cast<std::int64_t>(mantissa)) / powers[p - decimals];
    q = quantity(value, negative, integer, p - decimals);
    return p;
}

}  // namespace fagorc::frontend
