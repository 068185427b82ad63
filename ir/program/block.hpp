// The meaning of a block shape, made once and shared by all blocks of that shape.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "ir/diag/diagnostic.hpp"
#include "ir/program/statement.hpp"

namespace fagorc::program {

/// A finding about the shape of a block, with the tokens that it concerns; each block of the shape re-anchors it.
struct Finding {
    diag::Id id{};
    std::uint16_t token = 0, end_token = 0;
    std::vector<diag::Argument> arguments;
    std::uint32_t limit = 0;         ///< too_many_assignments: how many destinations a block may have
};

/// Findings that hold only for some blocks of a shape: `diagnostic_of` looks at the text (ir/program/findings.hpp).
constexpr bool depends_on_text(diag::Id id) {
    return id == diag::Id::empty_block || id == diag::Id::too_many_assignments || id == diag::Id::lower_case_word;
}

/// What all blocks of one shape have in common.
struct BlockTemplate {
    std::uint8_t skip_marks = 0;                 ///< bit 0..2: marks 1..3 (8055 T 2.1.1)
    std::optional<std::uint16_t> label_slot;     ///< N at the start
    std::optional<std::uint16_t> repeat_slot;    ///< N at the end
    std::uint16_t repeat_token = 0;
    bool by_parameter = false;                   ///< a G code comes from a parameter (GP1): bound when it is executed
    bool broken = false;                         ///< an error: the block has findings and no body
    std::variant<std::monostate, IsoBlock, Statement> body;
    std::vector<Word> words;                     ///< pool of the word runs
    std::vector<Node> nodes;                     ///< pool of the expressions
    std::vector<Finding> findings;
    std::size_t bytes = 0;                       ///< memory that it holds, for the bound of the cache

    std::span<const Word> run(WordRun r) const { return {words.data() + r.first, r.count}; }
    std::span<const Node> run(Expression e) const { return {nodes.data() + e.first, e.count}; }
};

/// A place to read from: the block that starts at `offset`, on physical line `line` (from 1).
struct Cursor {
    std::uint64_t offset = 0;
    std::uint32_t line = 1;
    friend bool operator==(const Cursor&, const Cursor&) = default;
};

/// A block with its numbers. Valid until the next read from the same program.
struct Block {
    const BlockTemplate* shape = nullptr;
    std::span<const Quantity> slots;
    std::string_view text;                       ///< the block's bytes without its line end
    Cursor here, next;
};

}  // namespace fagorc::program
