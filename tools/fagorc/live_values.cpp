#include "tools/fagorc/live_values.hpp"

#include <charconv>

namespace fagorc::tool {
namespace {

/// Whether a name is a variable of the control, an axis letter and an index behind it where the family has them.
bool is_variable(std::string_view name, const control::Dialect& dialect) {
    for (const control::Variable& v : dialect.variables) {
        if (!name.starts_with(v.name)) continue;
        std::string_view rest = name.substr(v.name.size());
        if (v.per_axis) {
            if (rest.empty() || !axis_of(rest.front())) continue;
            rest.remove_prefix(1);
        }
        if (rest.find_first_not_of("0123456789") == rest.npos && (rest.empty() || v.index != control::IndexForm::none))
            return true;
    }
    return false;
}

}  // namespace

bool SetValues::read(const std::vector<std::string>& options, const control::Dialect& dialect, diag::Sink& out) {
    bool good = true;
    for (const std::string& option : options) {
        const std::size_t equals = option.find('=');
        std::string name;
        for (char c : option.substr(0, equals))
            if (c != ' ') name += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        double value = 0;
        const char* from = equals == option.npos ? nullptr : option.data() + equals + 1;
        const char* end = option.data() + option.size();
        const auto result = from ? std::from_chars(from + (*from == '+'), end, value) : std::from_chars_result{};
        if (!from || name.empty() || result.ec != std::errc{} || result.ptr != end) {
            out.report(diag::Id::set_value_malformed, diag::Place{}, option);
            good = false;
            continue;
        }
        if (!is_variable(name, dialect)) out.report(diag::Id::set_name_unknown, diag::Place{}, name);
        values_[name] = value;
    }
    return good;
}

std::optional<double> SetValues::value(std::string_view name) {
    const auto at = values_.find(name);
    return at == values_.end() ? std::nullopt : std::optional(at->second);
}

}  // namespace fagorc::tool
