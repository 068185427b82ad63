#include "passes/execute/parameters.hpp"

#include <algorithm>

namespace fagorc::passes {

Parameters::Parameters(const control::Dialect& dialect, const std::map<std::uint32_t, double>& start)
    : most_levels_(static_cast<std::size_t>(dialect.limits.parameter_levels) + 1) {
    using Scope = control::ParameterRange::Scope;
    std::size_t size = 0;
    for (const control::ParameterRange& r : dialect.parameters) size = std::max<std::size_t>(size, r.last + 1);
    cells_.assign(size, 0);
    access_.assign(size, Access::none);
    for (const control::ParameterRange& r : dialect.parameters)
        std::fill(access_.begin() + r.first, access_.begin() + r.last + 1,
                  r.scope == Scope::oem ? Access::oem : Access::open);
    levels_.reserve(most_levels_);
    levels_.emplace_back();
    local_ = levels_.back().data();
    oem_allowed = true;  // the table of start values holds OEM parameters too
    for (const auto& [number, value] : start)
        if (double* cell = find(number)) *cell = value;
    oem_allowed = false;
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
