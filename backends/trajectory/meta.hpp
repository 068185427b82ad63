// What a trajectory file says about the compilation as a whole: the META text and the tool table.
#pragma once

#include <string>
#include <vector>

#include "backends/backend.hpp"
#include "backends/trajectory/format.hpp"

namespace fagorc::backends::trajectory {

/// JSON: producer, control, machine, units, policies, start (docs/trajectory-format.md).
std::string meta_text(const Job& job);

/// The rows of the tool table with their offsets, then the offsets that no tool takes on its own, by number.
std::vector<ToolRecord> tool_rows(const machine::Machine& machine);

}  // namespace fagorc::backends::trajectory
