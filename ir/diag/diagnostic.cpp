#include "ir/diag/diagnostic.hpp"

#include <fmt/format.h>

#include <cmath>

namespace fagorc::diag {
namespace {

/// Words of a program have at most five decimals (8055 T 3.3); what a computation leaves behind them tells nobody
/// anything. Values too small or too large for that form keep their own.
std::string readable_number(double value) {
    const double size = std::abs(value);
    if (!std::isfinite(value) || size >= 1e12 || (size > 0 && size < 1e-5)) return fmt::format("{:.6g}", value);
    std::string text = fmt::format("{:.5f}", value);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

}  // namespace

Argument::Argument(double value) : plain(readable_number(value)) {}

}  // namespace fagorc::diag
