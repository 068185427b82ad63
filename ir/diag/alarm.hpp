// The little notation of the alarm columns: "", "0046", "1155-1163" or "1090,1091,1096,1097".
#pragma once

#include <cstddef>
#include <string_view>

namespace fagorc::diag {

/// Digits of one alarm number: the 8055 shows four, the 8025 three.
inline constexpr std::size_t alarm_digits = 4;

constexpr bool is_alarm_number(std::string_view s) {
    if (s.size() != alarm_digits && s.size() != alarm_digits - 1) return false;
    for (char c : s)
        if (c < '0' || c > '9') return false;
    return true;
}

/// Whether a text is one number, a range upwards or a list of numbers; or empty.
constexpr bool is_alarm_column(std::string_view s) {
    if (s.empty()) return true;
    if (const std::size_t dash = s.find('-'); dash != s.npos) {
        const std::string_view first = s.substr(0, dash), last = s.substr(dash + 1);
        return is_alarm_number(first) && is_alarm_number(last) && first < last;
    }
    while (true) {
        const std::size_t comma = s.find(',');
        if (!is_alarm_number(s.substr(0, comma))) return false;
        if (comma == s.npos) return true;
        s.remove_prefix(comma + 1);
    }
}

/// Whether the number `alarm` ("0043") is one of a column's.
constexpr bool holds_alarm(std::string_view column, std::string_view alarm) {
    if (const std::size_t dash = column.find('-'); dash != column.npos)
        return alarm.size() == dash && column.substr(0, dash) <= alarm && alarm <= column.substr(dash + 1);
    while (true) {
        const std::size_t comma = column.find(',');
        if (column.substr(0, comma) == alarm) return !alarm.empty();
        if (comma == column.npos) return false;
        column.remove_prefix(comma + 1);
    }
}

static_assert(is_alarm_column("0046") && is_alarm_column("1155-1163") && is_alarm_column("1090,1091,1096"));
static_assert(!is_alarm_column("46") && !is_alarm_column("1163-1155") && !is_alarm_column("1090,") &&
              !is_alarm_column("alarm"));
static_assert(holds_alarm("1155-1163", "1163") && holds_alarm("1090,1091", "1091") && holds_alarm("0046", "0046"));
static_assert(!holds_alarm("1155-1163", "1164") && !holds_alarm("1090,1091", "109") && !holds_alarm("", ""));

}  // namespace fagorc::diag
