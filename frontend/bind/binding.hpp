// What the parts of the binder share while they make one template.
#pragma once

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "frontend/bind/syntax.hpp"
#include "ir/control/dialect.hpp"
#include "ir/diag/catalogue.hpp"
#include "ir/program/block.hpp"

namespace fagorc::frontend {

/// One block on its way to a template.
struct Binding {
    const control::Dialect& dialect;
    std::span<const syntax::Token> tokens;
    std::uint32_t motion_letters;  ///< of the dialect, see below
    program::BlockTemplate& out;

    /// A finding about tokens [first, end).
    template <class... Arguments>
    program::Finding& report(diag::Id id, std::uint32_t first, std::uint32_t end, Arguments&&... arguments) {
        program::Finding& f = out.findings.emplace_back();
        f.id = id;
        f.token = static_cast<syntax::Index>(first);
        f.end_token = static_cast<syntax::Index>(end);
        (f.arguments.emplace_back(std::forward<Arguments>(arguments)), ...);
        return f;
    }
    /// How messages call a token: `X`, `G91`, `GOTO`, "a number", "the end of the block".
    diag::Argument named(std::uint32_t token) const;
    /// Whether a finding holds for all blocks of the shape and is an error.
    bool has_error() const {
        return std::any_of(out.findings.begin(), out.findings.end(), [](const program::Finding& f) {
            return !program::depends_on_text(f.id) && diag::row(f.id).severity == diag::Severity::error;
        });
    }
};

/// The tokens of a key, without its mark for lower case.
std::vector<syntax::Token> tokens_of(std::string_view key);

/// Says what is wrong at the token where a block broke off.
void explain(Binding& b, const syntax::Error& error);
/// `GOTO N10` without parentheses is a row of ISO words that mean nothing: for a block with an error. True when its
/// letters spell a statement; that is then the only finding.
bool explain_statement_without_parentheses(Binding& b);

/// Letters that codes of the motion take besides the axes, e.g. I J K R Q L: bit 0 is A.
std::uint32_t motion_letters(const control::Dialect& dialect);
/// Sorts the words of an ISO block, which may end with an N that says how often.
program::IsoBlock bind_iso(Binding& b, std::span<const syntax::Item> items);
/// Order of the codes and of the words that belong to none, e.g. G X Z F S T D M (8055 T 5).
void check_order(Binding& b, std::span<const syntax::Item* const> items);
/// Which codes and words may stand in one block (8055 T 5.1).
void check_company(Binding& b, const program::IsoBlock& block);
/// Whether the codes have the operands that they need, and no other.
void check_operands(Binding& b, const program::FunctionCall& call);

/// The call that a G code makes (8055 T 12.5.1).
program::Statement bind_call(Binding& b, const syntax::Call& call);
/// A statement, typed. Where a part is missing a finding says so and the statement is not to be used.
program::Statement bind_statement(Binding& b, const syntax::Statement& s);
/// The statements of customisation programs (8055 T 12.9).
program::Screen bind_screen(Binding& b, const syntax::Statement& s);
/// Reports when a statement has not as many operands as its row in the table says.
void check_operand_count(Binding& b, const syntax::Statement& s);

/// Static types, depth and access of an expression whose nodes stand in the template's pool (8055 T 11.4, 11.5).
void check_expression(Binding& b, program::Expression e);
/// Whether a program may write to this destination.
void check_target(Binding& b, const program::Target& target);

}  // namespace fagorc::frontend
