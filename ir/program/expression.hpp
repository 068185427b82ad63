// Expressions as postfix code: one small node after the other, evaluated on a stack without allocation.
#pragma once

#include <cstdint>

#include "ir/program/token.hpp"

namespace fagorc::program {

/// What a node does to the stack of values.
enum class Operator : std::uint8_t {
    number,        ///< push the value of slot `slot`
    constant,      ///< push `operand` itself: a number that is part of the shape (the subroutine that G180 calls)
    pi,
    parameter,     ///< push parameter number = value of slot `slot` (P100)
    letter,        ///< push local parameter `operand` (A = 0 .. Z = 25)
    indirect,      ///< pop a parameter number, push that parameter: P(expression)
    variable,      ///< push variable `operand` (payload of its token); with an index: pop the index first
    entry,         ///< pop the number of a data-entry variable, push its value: IB5 (8055 T 12.9)
    position,      ///< GPOS: pop the program number, pop the label, push the coordinate
    negate, not_,
    add, subtract, multiply, divide, power, modulo,
    compare,       ///< `operand` = Relation; pushes 1 or 0
    and_, or_, xor_,
    function,      ///< `operand` = Function1
    arg            ///< ARG(x, y): angle of a point, 0..360 degrees
};

/// One node. `condition` is the static type of what it pushes: NOT, AND, OR and XOR of conditions are logical,
/// of anything else binary on 32 bits (8055 T 11.4).
struct Node {
    Operator op{};
    bool condition = false;
    bool indexed = false;            ///< variable: an index stands on the stack
    bool logical = false;            ///< not_, and_, or_, xor_: all operands are conditions
    std::uint16_t operand = 0;
    std::uint16_t slot = 0;
    std::uint16_t token = 0;         ///< the token that a diagnostic marks
};

/// A run of nodes in the block's node pool. Empty where the expression is absent.
struct Expression {
    std::uint16_t first = 0;
    std::uint16_t count = 0;
    std::uint16_t token = 0;         ///< first and
    std::uint16_t end_token = 0;     ///< one past the last token that it covers
    constexpr bool present() const { return count != 0; }
};

/// Deepest stack that an expression may need; a deeper one is refused when it is bound.
inline constexpr int max_expression_depth = 64;

}  // namespace fagorc::program
