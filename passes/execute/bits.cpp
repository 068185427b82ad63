#include "passes/execute/bits.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

namespace fagorc::passes::bits {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
constexpr int nibbles = 8;

/// The integer part modulo 2^32: a negative number in two's complement.
std::uint32_t pattern(double a) {
    constexpr double modulus = 4294967296.0;
    const double rest = std::fmod(std::trunc(a), modulus);
    return static_cast<std::uint32_t>(rest < 0 ? rest + modulus : rest);
}

}  // namespace

double not_(double a, bool logical) {
    if (std::isnan(a)) return a;
    return logical ? a == 0 : ~pattern(a);
}

double and_(double a, double b, bool logical) {
    if (a == 0 || b == 0) return 0;
    if (std::isnan(a) || std::isnan(b)) return unknown;
    return logical ? 1 : pattern(a) & pattern(b);
}

double or_(double a, double b, bool logical) {
    const bool known_a = !std::isnan(a), known_b = !std::isnan(b);
    if (logical && ((known_a && a != 0) || (known_b && b != 0))) return 1;
    if (!known_a || !known_b) return unknown;
    return logical ? 0 : pattern(a) | pattern(b);
}

double xor_(double a, double b, bool logical) {
    if (std::isnan(a) || std::isnan(b)) return unknown;
    return logical ? (a != 0) != (b != 0) : pattern(a) ^ pattern(b);
}

std::optional<double> bcd(double a) {
    if (std::isnan(a)) return a;
    if (a < 0 || a >= 1e8) return std::nullopt;
    std::uint32_t rest = static_cast<std::uint32_t>(a), packed = 0;
    for (int n = 0; n < nibbles; ++n, rest /= 10) packed |= (rest % 10) << (4 * n);
    return packed;
}

double bin(double a) {
    if (std::isnan(a)) return a;
    const std::uint32_t packed = pattern(a);
    double value = 0;
    for (int n = nibbles - 1; n >= 0; --n) {
        const std::uint32_t digit = packed >> (4 * n) & 15;
        if (digit > 9) return packed;
        value = 10 * value + digit;
    }
    return value;
}

}  // namespace fagorc::passes::bits
