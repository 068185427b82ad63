#include "frontend/scan/quantity.hpp"

#include <charconv>
#include <string>

namespace fagorc::frontend {
namespace {

constexpr double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                             1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
/// Up to so many digits an integer is exact in a double, and so is one division by an exact power of ten.
constexpr unsigned exact_digits = 15;

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
bool is_blank(char c) {
    return c == ' ' || c == '\t';
}

/// Numbers with more digits than one division can round correctly: rare, so the library reads them.
double read_long(const char* from, const char* to) {
    std::string digits;
    for (; from != to; ++from)
        if (!is_blank(*from)) digits += *from;
    double value = 0;
    std::from_chars(digits.data(), digits.data() + digits.size(), value);
    return value;
}

}  // namespace

const char* read_quantity(const char* p, bool negative, program::Quantity& q) {
    const char* const from = p;
    const char* to = p;
    std::uint64_t mantissa = 0;
    unsigned significant = 0, integer = 0, decimals = 0;
    bool point = false, digits = false;
    for (;; ++p) {
        if (is_digit(*p)) {
            digits = true;
            significant += significant || *p != '0';
            if (significant <= exact_digits) mantissa = mantissa * 10 + static_cast<std::uint64_t>(*p - '0');
            if (point)
                ++decimals;
            else
                integer += integer || *p != '0';
            to = p + 1;
        } else if (*p == '.' && !point) {
            point = true;
            to = p + 1;
        } else if (!is_blank(*p)) {
            break;
        }
    }
    if (!digits) return from;
    q.value = significant <= exact_digits && decimals < std::size(powers)
                  ? static_cast<double>(mantissa) / powers[decimals]
                  : read_long(from, to);
    if (negative && q.value != 0) q.value = -q.value;
    q.integer_digits = static_cast<std::uint8_t>(integer < 255 ? integer : 255);
    q.decimals = static_cast<std::uint8_t>(decimals < 127 ? decimals : 127) & 0x7f;
    return to;
}

}  // namespace fagorc::frontend
