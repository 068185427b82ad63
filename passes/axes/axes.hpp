// Axes: programmed coordinates become machine coordinates (docs/order.md: the path).
#pragma once

#include <memory>

#include "passes/pass.hpp"

namespace fagorc::passes {

/// In: points from the part zero. Out: points of the tool tip from the machine zero: the zero offset of the frame is
/// added. G53 blocks are machine coordinates already. Tool lengths stay in the state: what is stored is the tip.
std::unique_ptr<Pass> make_axes(const Environment& environment, operation::Sink& next);

}  // namespace fagorc::passes
