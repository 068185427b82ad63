// Operations as lines of text, for dumps and tests.
#pragma once

#include <string>

#include "ir/operation/operation.hpp"

namespace fagorc::operation {

/// One line: where it comes from, what it does, six decimals: `12 line Z=-10.000000 X=20.000000 F=0.250000 mm/rev`.
/// Coordinates are named by the axes of the operation's plane.
std::string describe(const Operation& operation, const Tables& tables);

}  // namespace fagorc::operation
