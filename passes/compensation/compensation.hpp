// Compensation: the nose circle stays tangent to the contour; the tip follows (8055 T 8).
#pragma once

#include <memory>

#include "passes/pass.hpp"

namespace fagorc::passes {

/// In: contour elements under G41 or G42. Out: the path of the tool tip.
/// G41 and G42 are known rows that the executor refuses as yet, so every element is its own path.
std::unique_ptr<Pass> make_compensation(const Environment& environment, operation::Sink& next);

}  // namespace fagorc::passes
