// What the command line does with trajectory files: verify them, and print every block as text.
#pragma once

#include <string>

#include "backends/output.hpp"
#include "ir/diag/diagnostic.hpp"
#include "runtime/player/blocks.hpp"

namespace fagorc::tool {

/// Checks every byte of a file and reports the first thing that is wrong with it. True where nothing is.
bool verify_trajectory(const std::string& name, player::Bytes file, diag::Sink& out);

/// Prints the blocks of a file in their order, a line for each block and each record (docs/trajectory-format.md). What
/// cannot be read is reported; what comes before it is printed. False where something was reported.
bool dump_trajectory(const std::string& name, player::Bytes file, backends::Output& output, diag::Sink& out);

}  // namespace fagorc::tool
