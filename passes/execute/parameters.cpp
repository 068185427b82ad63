#include "passes/execute/parameters.hpp"

#include <algorithm>

namespace fagorc::passes {

using Scope = control::ParameterRange::Scope;

Parameters::Parameters(const control::Dialect& dialect, const std::map<std::uint32_t, double>& start)
    : dialect_(dialect), most_levels_(static_cast<std::size_t>(dialect.limits.parameter_levels) + 1) {
    for (const control::ParameterRange& r : dialect.parameters) size_ = std::max(size_, r.last + 1);
    globals_.assign(size_, 0);
    cell_of_.assign(size_, nullptr);
    for (const control::ParameterRange& r : dialect.parameters)
        if (r.scope != Scope::oem)
            for (std::uint32_t n = r.first; n <= r.last; ++n) cell_of_[n] = &globals_[n];
    levels_.reserve(most_levels_);
    levels_.emplace_back();
    place_locals();
    allow_oem(true);  // the table of start values holds OEM parameters too
    for (const auto& [number, value] : start)
        if (double* cell = find(number)) *cell = value;
    allow_oem(false);
}

void Parameters::place_locals() {
    Level& level = levels_.back();
    for (std::uint32_t n = 0; n < std::min(local_count, size_); ++n) cell_of_[n] = &level[n];
}

void Parameters::allow_oem(bool allowed) {
    if (allowed == oem_allowed_) return;
    oem_allowed_ = allowed;
    for (const control::ParameterRange& r : dialect_.parameters)
        if (r.scope == Scope::oem)
            for (std::uint32_t n = r.first; n <= r.last; ++n) cell_of_[n] = allowed ? &globals_[n] : nullptr;
}

bool Parameters::is_oem(std::uint32_t number) const {
    return std::any_of(dialect_.parameters.begin(), dialect_.parameters.end(), [&](const control::ParameterRange& r) {
        return r.scope == Scope::oem && number >= r.first && number <= r.last;
    });
}

bool Parameters::enter() {
    if (levels_.size() == most_levels_) return false;
    levels_.emplace_back();
    place_locals();
    return true;
}

void Parameters::leave() {
    levels_.pop_back();
    place_locals();
}

}  // namespace fagorc::passes
