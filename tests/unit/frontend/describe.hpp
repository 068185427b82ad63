// A template as text, so that tests can compare two of them.
#pragma once

#include <string>

#include "ir/program/block.hpp"

namespace fagorc::frontend {

/// Everything that a template says, but the memory that it holds.
std::string describe(const program::BlockTemplate& shape);

}  // namespace fagorc::frontend
