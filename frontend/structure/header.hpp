// The first line of a program file: %comment,attributes, (8055 T 1.1).
#pragma once

#include <string_view>

#include "ir/program/program.hpp"

namespace fagorc::frontend {

/// Reads a header line without its line end. `well_formed` is false for a comment that is too long, a missing comma or
/// a foreign letter among the attributes: the control then shows asterisks and changes nothing.
program::Header read_header(std::string_view line, bool& well_formed);

}  // namespace fagorc::frontend
