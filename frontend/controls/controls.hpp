// The controls that the front end knows.
#pragma once

#include <span>
#include <string_view>

#include "ir/control/dialect.hpp"

namespace fagorc::frontend {

/// All dialects, by name.
std::span<const control::Dialect* const> dialects();
/// The dialect of a name ("8055"); null for an unknown one.
const control::Dialect* dialect(std::string_view name);

}  // namespace fagorc::frontend
