// Findings of a shape, told about one of its blocks.
#pragma once

#include <string_view>

#include "ir/base/text.hpp"
#include "ir/program/program.hpp"

namespace fagorc::program {

/// Reports all findings of a block's template at the places of the block's own tokens. Characters that no block can
/// hold are named.
void report_findings(Program& program, const Block& block, diag::Sink& out);

/// A character that is not ASCII, by the names that people know it by; and the character that it is mistaken for, 0
/// where there is none.
struct CharacterName {
    Text name;
    char looks_like = 0;
};
/// The name of a character given as UTF-8 or as one Latin-1 byte; null for one without a name here.
const CharacterName* name_of_character(std::string_view bytes);

}  // namespace fagorc::program
