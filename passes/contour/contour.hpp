// Contour: elements that need their neighbours become lines and arcs (8055 T 6.8 - 6.11).
#pragma once

#include <memory>

#include "passes/pass.hpp"

namespace fagorc::passes {

/// In: corners G36..G39 between programmed elements. Out: lines and arcs alone.
/// The corner functions are known rows that the executor refuses as yet, so nothing here waits for a neighbour.
std::unique_ptr<Pass> make_contour(const Environment& environment, operation::Sink& next);

}  // namespace fagorc::passes
