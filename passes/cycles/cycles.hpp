// Cycles: a canned cycle becomes the moves that the control makes, pass by pass (8055 T 9).
#pragma once

#include <memory>

#include "passes/pass.hpp"

namespace fagorc::passes {

/// In: neutral cycle operations (ir/operation/cycle.hpp) with their profiles. Out: moves; a finishing pass is
/// compensation on, path, compensation off. The cycles are known rows that the executor refuses as yet, so none
/// arrives.
std::unique_ptr<Pass> make_cycles(const Environment& environment, operation::Sink& next);

}  // namespace fagorc::passes
