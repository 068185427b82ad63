#include "frontend/scan/quantity.hpp"

#include <algorithm>
#include <charconv>
#include <string>

namespace fagorc::frontend {

const char* read_long_quantity(const char* p, bool negative, program::Quantity& q) {
    std::string digits;
    std::ptrdiff_t integer = 0, decimals = 0;
    bool point = false;
    const char* to = p;
    for (;; ++p) {
        if (is_blank(*p)) continue;
        const bool digit = digit_value(*p) < 10;
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
    q.hexadecimal = 0;
    q.value = negative ? 0.0 - value : value;  // the sign of nothing is plus
    q.integer_digits = static_cast<std::uint8_t>(std::min<std::ptrdiff_t>(integer, 255));
    q.decimals = static_cast<std::uint8_t>(std::min<std::ptrdiff_t>(decimals, 127)) & 0x7f;
    return to;
}

}  // namespace fagorc::frontend
