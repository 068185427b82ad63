#include "backends/text.hpp"

#include <charconv>
#include <limits>

namespace fagorc::backends {
namespace {

/// Enough for the largest double in fixed notation.
constexpr std::size_t longest = std::numeric_limits<double>::max_exponent10 + 32;

bool is_zero(std::string_view number) {
    return number.find_first_of("123456789") == number.npos;
}

std::string_view without_sign_of_zero(std::string_view number) {
    if (number.front() == '-' && is_zero(number)) number.remove_prefix(1);
    return number;
}

}  // namespace

void append_fixed(std::string& out, double value, int decimals) {
    char buffer[longest];
    const auto [end, error] = std::to_chars(buffer, buffer + longest, value, std::chars_format::fixed, decimals);
    out += without_sign_of_zero({buffer, end});
}

void append_trimmed(std::string& out, double value, int decimals) {
    char buffer[longest];
    const auto [end, error] = std::to_chars(buffer, buffer + longest, value, std::chars_format::fixed, decimals);
    std::string_view text = without_sign_of_zero({buffer, end});
    if (text.find('.') != text.npos) {
        text = text.substr(0, text.find_last_not_of('0') + 1);
        if (text.back() == '.') text.remove_suffix(1);
    }
    out += text;
}

void append_shortest(std::string& out, double value) {
    char buffer[longest];
    const auto [end, error] = std::to_chars(buffer, buffer + longest, value == 0 ? 0 : value);
    out.append(buffer, end);
}

void append_whole(std::string& out, std::uint64_t value) {
    char buffer[24];
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
    out.append(buffer, end);
}

}  // namespace fagorc::backends
