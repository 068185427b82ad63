// Check: what the machine cannot or must not do is found before it moves (docs/order.md: the path).
#pragma once

#include <memory>

#include "passes/pass.hpp"

namespace fagorc::passes {

/// In and out: the same operations, in machine coordinates of the tool tip. Finds moves beyond the travel of an axis,
/// at their ends and at the extremes of arcs (alarms 1155-1163).
std::unique_ptr<Pass> make_check(const Environment& environment, operation::Sink& next);

}  // namespace fagorc::passes
