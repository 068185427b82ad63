// Reads the digits of a number.
#pragma once

#include "ir/program/token.hpp"

namespace fagorc::frontend {

/// Reads digits and a point from `p`; blanks between them mean nothing (8055 T 2.1: `X 3 0` is X30). Sets value and
/// digit counts of `q`, correctly rounded. Returns the place behind the last digit; `p` where there is no digit.
const char* read_quantity(const char* p, bool negative, program::Quantity& q);

}  // namespace fagorc::frontend
