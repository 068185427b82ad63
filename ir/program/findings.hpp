// Findings of a shape, told about one of its blocks.
#pragma once

#include <optional>
#include <string_view>

#include "ir/base/text.hpp"
#include "ir/program/program.hpp"

namespace fagorc::program {

/// A finding of the block's template at the places of the block's own tokens, with what only its text tells: the name
/// of a character that no block can hold, the word in lower case. Nothing where the text of this block does not bear it
/// out: a label alone is an error without a comment beside it, and assignments count by their destinations.
std::optional<diag::Diagnostic> diagnostic_of(Program& program, const Block& block, const Finding& finding);

/// Reports all findings of a block; true when one of them is an error.
bool report_findings(Program& program, const Block& block, diag::Sink& out);

/// A character that is not ASCII, by the names that people know it by; and the character that it is mistaken for, 0
/// where there is none.
struct CharacterName {
    Text name;
    char looks_like = 0;
};
/// The name of a character given as UTF-8 or as one Latin-1 byte; null for one without a name here.
const CharacterName* name_of_character(std::string_view bytes);

}  // namespace fagorc::program
