// A control as data: everything that distinguishes one language from another.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ir/control/construct.hpp"
#include "ir/control/variable.hpp"
#include "ir/program/modal.hpp"
#include "ir/program/token.hpp"

namespace fagorc::control {

/// A reserved word of the high-level language: its text and the token that it makes.
struct ReservedWord {
    std::string_view text{};
    program::Token token{};
    std::uint16_t payload = 0;
    bool text_follows = false;     ///< the rest of the block up to the closing parenthesis is one text (WRITE)
};

/// A statement, an operator or an address letter as hover, explain and the reference describe it. What it does stands
/// in the grammar and the executor.
struct StatementRow {
    std::string_view word{};
    Support support = Support::executed;
    std::string_view syntax{}, snippet{}, section{};
    Text title{};
    std::span<const Operand> operands{};   ///< letters, or '1' '2' ... for those known by their place; without slots
};

/// A missing language or an empty field does not compile.
consteval bool well_formed(const StatementRow& row) {
    for (const Operand& o : row.operands)
        if (!o.text.complete() || o.range.least > o.range.most || o.slot.set) return false;
    return row.title.complete() && !row.word.empty() && !row.syntax.empty() && !row.snippet.empty() && !row.section.empty();
}
consteval bool well_formed(std::span<const StatementRow> rows) {
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!well_formed(rows[i])) return false;
        for (std::size_t k = 0; k < i; ++k)
            if (rows[k].word == rows[i].word) return false;
    }
    return true;
}

/// A range of parameter numbers and where it lives.
struct ParameterRange {
    std::uint32_t first = 0, last = 0;
    enum class Scope : std::uint8_t { local, global, user, oem } scope = Scope::global;
};

/// Number format of a class of words: digits before and after the point.
struct NumberFormat { int integer_digits = 5; int decimals_mm = 4; int decimals_inch = 5; };

/// Limits of the language (8055 T 2, 5.7, 11, 12).
struct Limits {
    int subroutine_levels = 15;
    int parameter_levels = 6;
    int misc_per_block = 7;
    std::uint32_t misc = 9999;         ///< highest M
    int assignments_per_block = 26;
    std::uint32_t label = 99999999;
    std::uint32_t repetitions = 9999;
    std::uint32_t subroutine = 9999;
    std::size_t local_subroutines = 100;   ///< of a program (8055 T 2.2)
    std::uint32_t oem_subroutine_first = 10000, oem_subroutine_last = 20000;
    std::size_t text_length = 59;
    std::size_t block_bytes = 65536;   ///< ours: a longer line is one diagnostic
};

/// A code that the sister model of a control has and the control has not (8055 M and 8055 T).
struct SisterCode {
    char letter = 'G';
    std::uint16_t number = 0;
    Text title;
};

/// A word of the sister model's high-level language that the control has not.
struct SisterWord {
    std::string_view word{};
    Text title;
};

struct Dialect {
    std::string_view name;                             ///< "8055"
    std::string_view model, sister_model;              ///< "8055 T", "8055 M"
    Text title;
    std::string_view word_order;                       ///< order of addresses in an ISO block: "GXYZUVWABCFSTDM"
    std::span<const Construct* const> constructs;      ///< by letter, then number
    std::span<const SisterCode> sister_codes;          ///< named in the diagnostic of an unknown code
    std::span<const SisterWord> sister_words;          ///< likewise
    std::span<const StatementRow> statements;
    std::span<const StatementRow> operators;           ///< of expressions, functions among them
    std::span<const StatementRow> addresses;           ///< letters of an ISO block that belong to no code
    std::span<const Variable> variables;
    std::span<const ReservedWord> words;               ///< keywords, functions, relations (variables are added by the scanner)
    std::span<const ParameterRange> parameters;
    NumberFormat coordinate{5, 4, 5}, centre{6, 5, 5}, constant{6, 5, 5};
    Limits limits;
    program::Modal power_on;

    /// The row of a code; null where the control has none.
    const Construct* find(char letter, std::uint16_t number) const;
    /// The code of the sister model; null where that has none either.
    const SisterCode* find_sister(char letter, std::uint16_t number) const;
    const SisterWord* find_sister(std::string_view word) const;
    /// The text of a keyword, function or relation; empty where the control has no such word.
    std::string_view word(program::Token kind, std::uint16_t payload) const;
    std::string_view word(program::Keyword keyword) const {
        return word(program::Token::keyword, static_cast<std::uint16_t>(keyword));
    }
    /// The name of a variable with its axis letter: "POSX". Empty for a payload of no row.
    std::string variable_name(std::uint16_t payload) const;
    /// The row of a statement's word ("GOTO"); null where the control has none.
    const StatementRow* find_statement(std::string_view word) const;
};

}  // namespace fagorc::control
