// The verifier that stands after a pass and states what must hold there.
#pragma once

#include <memory>
#include <string_view>

#include "passes/pass.hpp"

namespace fagorc::passes {

/// Passes operations on and reports invariant_broken (an error of ours, not of the program) when a coordinate is not a
/// number, an arc has no radius or its radii disagree at its ends, a thread has no lead, or a handle names nothing.
std::unique_ptr<Pass> make_verifier(const Environment& environment, operation::Sink& next, std::string_view after);

}  // namespace fagorc::passes
