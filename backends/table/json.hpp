// Everything that a trajectory says, as JSON lines (docs/json.md): one object a line.
#pragma once

#include <memory>

#include "backends/backend.hpp"
#include "backends/output.hpp"

namespace fagorc::backends {

std::unique_ptr<operation::Sink> make_json_writer(const Job& job, Output& output);

}  // namespace fagorc::backends
