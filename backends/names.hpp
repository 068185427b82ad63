// Names of moves and events in text outputs and dumps.
#pragma once

#include <string_view>

#include "ir/operation/operation.hpp"

namespace fagorc::backends {

/// "misc", "tool" ... as docs/csv.md and docs/json.md list them.
std::string_view name(operation::Event::Kind kind);
/// "stop", "live_stop", "position_stop".
std::string_view name(operation::Barrier::Why why);

}  // namespace fagorc::backends
