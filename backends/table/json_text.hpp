// The rare lines of the JSON output: header and states, and texts as JSON strings.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "backends/numbering.hpp"

namespace fagorc::backends {

/// Bytes of a program as a JSON string with its quotes: UTF-8 stays; what is none is read as Latin-1.
std::string json_string(std::string_view bytes);

/// The first line: who wrote it, units, machine, where the tool stood.
std::string json_header(const Job& job);

/// The line of a state (docs/json.md).
std::string json_state(const Job& job, std::uint32_t number, const Situation& situation);

}  // namespace fagorc::backends
