// Reads the digits of a number.
#pragma once

#include "ir/program/token.hpp"

namespace fagorc::frontend {

/// Reads digits and a point from `p`; blanks between them mean nothing (8055 T 2.1: `X 3 0` is X30). Sets value,
/// correctly rounded, and digit counts of `q`, and leaves its place at 0. Returns the place behind the last digit; `p`
/// where there is no digit.
const char* read_quantity(const char* p, bool negative, program::Quantity& q);

}  // namespace fagorc::frontend
