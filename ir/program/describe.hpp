// Templates as people read them, for `dump --stage program` and for tests.
#pragma once

#include <string>

#include "ir/control/dialect.hpp"
#include "ir/program/block.hpp"

namespace fagorc::program {

/// One line, the same for the same template: what the block does, with `#n` for the number or text in slot n.
///   label=#0 modal[G01] X=#1 Z=-P#2 F=#3 misc[M03]
///   if(eq(P#0, #1), goto(#2), else assign(A = add(B, 3)))
/// Findings come last, by the names of the catalogue, with the tokens that they mark.
std::string describe(const BlockTemplate& shape, const control::Dialect& dialect);

/// An expression in prefix form: `add(P#0, multiply(#1, POSX))`.
std::string describe(const BlockTemplate& shape, Expression expression, const control::Dialect& dialect);

}  // namespace fagorc::program
