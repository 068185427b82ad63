#include "frontend/controls/controls.hpp"

#include <algorithm>
#include <array>

#include "frontend/controls/fagor8055/fagor8055.hpp"

namespace fagorc::frontend {

std::span<const control::Dialect* const> dialects() {
    static const std::array<const control::Dialect*, 1> all = {&fagor8055::dialect()};
    return all;
}

const control::Dialect* dialect(std::string_view name) {
    const auto all = dialects();
    const auto at = std::find_if(all.begin(), all.end(), [name](const auto* d) { return d->name == name; });
    return at != all.end() ? *at : nullptr;
}

}  // namespace fagorc::frontend
