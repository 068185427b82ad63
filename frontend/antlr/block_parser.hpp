// The parser that ANTLR generates, behind a wall: tokens in, our own syntax or the place of the first error out.
#pragma once

#include <memory>
#include <span>
#include <variant>

#include "frontend/bind/syntax.hpp"
#include "ir/control/dialect.hpp"

namespace fagorc::frontend {

/// Parses one block at a time. Nothing of ANTLR, no exception among it, leaves this class. Not for two threads at once.
class BlockParser {
  public:
    /// The tables tell the forms of a token that the grammar distinguishes: whether a G code calls a subroutine, which
    /// index a variable takes.
    explicit BlockParser(const control::Dialect& dialect);
    ~BlockParser();

    /// Stops at the first error. The depth of parentheses is the caller's to bound: the parser recurses.
    std::variant<syntax::Block, syntax::Error> parse(std::span<const syntax::Token> tokens);

  private:
    struct Antlr;
    std::unique_ptr<Antlr> antlr_;
};

}  // namespace fagorc::frontend
