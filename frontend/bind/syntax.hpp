// What the grammar sees in a block: words, statements and expressions by their tokens, before the control's tables give
// them a meaning. The fence in frontend/antlr makes it, the binder reads it.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ir/program/statement.hpp"
#include "ir/program/token.hpp"

namespace fagorc::frontend::syntax {

/// Place of a token in its block, from 0.
using Index = std::uint16_t;

/// One token of a shape key.
struct Token {
    program::Token kind{};
    std::uint16_t payload = 0;
    std::uint16_t slot = 0;  ///< number, text, invalid character: the place of its quantity in the block
};

/// A word of an ISO block, or a code: G or M with digits that are part of the shape.
struct Item {
    program::Word word;  ///< of a code: the letter, no value
    std::optional<std::uint16_t> code;
};

/// A G code that calls a subroutine, with what it passes (8055 T 12.5.1).
struct Call {
    Index token = 0;
    std::uint16_t number = 0;
    std::vector<program::Assignment> arguments;
};

/// Tokens [first, end): letters that spell a name, or the word of a device.
struct Name {
    Index first = 0, end = 0;
};

/// One statement. Which lists are filled depends on its word; each is in the order written.
struct Statement {
    std::optional<program::Keyword> word;  ///< nothing: a list of assignments
    Index token = 0, end_token = 0;
    std::vector<program::Expression> operands;  ///< labels and program numbers too
    std::vector<program::Assignment> assignments;
    std::vector<Index> texts;
    std::vector<Name> names;
    std::vector<Statement> then, otherwise;  ///< actions of IF and ELSE, one or none
    std::optional<Index> alternative;        ///< the word ELSE
};

/// One block without syntax error. At most one of items with call, and statement, is there.
struct Block {
    std::vector<Index> skip_marks;
    std::optional<program::Word> label, repetition;
    std::vector<Item> items;
    std::optional<Call> call;
    std::optional<Statement> statement;
    std::vector<program::Node> nodes;   ///< pool of the expressions; static types are not yet in
    std::vector<Index> bare_arguments;  ///< functions of something that is neither constant nor in parentheses
};

/// Where in the grammar a block broke off.
enum class Rule : std::uint8_t {
    block,      ///< between its parts
    iso,        ///< in an ISO word
    statement,  ///< at the start of a statement
    action,     ///< at the start of the action of IF or ELSE
    list,       ///< after an item of a list
    name,       ///< where a device or an axis is named
    index,      ///< where the number of an entry stands
    operand,    ///< where an operand of an expression stands
    other
};

/// What could have stood there, as far as a message distinguishes it.
enum Expected : std::uint16_t {
    expects_end = 1,
    expects_number = 2,
    expects_text = 4,
    expects_comma = 8,
    expects_equals = 16,
    expects_left = 32,
    expects_right = 64,
    expects_program = 128,
    expects_operand = 256,
    expects_label = 512,
    expects_input = 1024
};

/// The first token that fits no block; one past the last token where the block ends too early.
struct Error {
    Rule rule = Rule::block;
    Index token = 0;
    std::uint16_t expected = 0;  ///< of Expected
};

}  // namespace fagorc::frontend::syntax
