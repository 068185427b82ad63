// The trajectory file (docs/trajectory-format.md): the main output, exact moves with their origin and state.
#pragma once

#include <memory>

#include "backends/backend.hpp"
#include "backends/output.hpp"

namespace fagorc::backends {

/// A sink that writes a .ftj file, front to back, in memory that does not grow with the number of moves. The same
/// operations, machine and programs give the same bytes.
std::unique_ptr<operation::Sink> make_trajectory_writer(const Job& job, Output& output);

}  // namespace fagorc::backends
