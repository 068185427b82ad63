// The tables of the Fagor 8055 T. Each returns a table that lives as long as the program.
#pragma once

#include <span>

#include "ir/control/dialect.hpp"

namespace fagorc::frontend::fagor8055 {

/// The whole control: everything below, with its limits and its power-on state.
const control::Dialect& dialect();

/// G and M codes, by letter, then number.
std::span<const control::Construct* const> constructs();
/// G codes of the mill model that this model has not.
std::span<const control::SisterCode> mill_codes();
/// Its statements and variables that this model has not.
std::span<const control::SisterWord> mill_words();
/// Keywords, functions and relations of the high-level language (8055 T 11.1).
std::span<const control::ReservedWord> words();
/// Variables, from variables.tsv.
std::span<const control::Variable> variables();
/// Statements of chapter 12.
std::span<const control::StatementRow> statements();
/// Operators and functions of expressions (8055 T 11.4).
std::span<const control::StatementRow> operators();
/// Address letters of an ISO block (8055 T 2.1, 3.6, 5).
std::span<const control::StatementRow> addresses();

}  // namespace fagorc::frontend::fagor8055
