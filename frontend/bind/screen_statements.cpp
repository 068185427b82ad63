// Statements of customisation programs: screen, keys, windows (8055 T 12.9).
#include "frontend/bind/binding.hpp"

namespace fagorc::frontend {

using program::Keyword;

program::Screen bind_screen(Binding& b, const syntax::Statement& s) {
    program::Screen out{*s.word, s.operands, {}};
    for (const syntax::Index t : s.texts) out.text_slots.push_back(b.tokens[t].slot);
    if (*s.word == Keyword::page || *s.word == Keyword::symbol || *s.word == Keyword::odw) check_operand_count(b, s);
    return out;
}

}  // namespace fagorc::frontend
