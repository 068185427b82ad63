#include "passes/execute/parameters.hpp"

namespace fagorc::passes {

Parameters::Parameters(const control::Dialect& dialect, const std::map<std::uint32_t, double>& start)
    : most_levels_(static_cast<std::size_t>(dialect.limits.parameter_levels) + 1) {
    std::uint32_t offset = 0;
    for (const control::ParameterRange& r : dialect.parameters) {
        if (r.scope == control::ParameterRange::Scope::local) continue;
        const std::uint32_t size = r.last - r.first + 1;
        ranges_.push_back({r.first, size, offset, r.scope == control::ParameterRange::Scope::oem});
        offset += size;
    }
    globals_.assign(offset, 0);
    levels_.reserve(most_levels_);
    levels_.emplace_back();
    local_ = levels_.back().data();
    oem_allowed = true;  // the table of start values holds OEM parameters too
    for (const auto& [number, value] : start)
        if (double* cell = find(number)) *cell = value;
    oem_allowed = false;
}

bool Parameters::is_oem(std::uint32_t number) const {
    for (const Range& r : ranges_)
        if (number - r.first < r.size) return r.oem;
    return false;
}

bool Parameters::enter() {
    if (levels_.size() == most_levels_) return false;
    local_ = levels_.emplace_back().data();
    return true;
}

void Parameters::leave() {
    levels_.pop_back();
    local_ = levels_.back().data();
}

}  // namespace fagorc::passes
