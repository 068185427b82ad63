#include "frontend/scan/lexicon.hpp"

#include <string>

namespace fagorc::frontend {
namespace {

/// Index of a character of a name; negative for one that no name has.
constexpr int symbol(char c) {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a';
    if (c >= '0' && c <= '9') return 26 + c - '0';
    return -1;
}

}  // namespace

Lexicon::Lexicon(const control::Dialect& dialect) : nodes_(1) {
    for (const control::ReservedWord& w : dialect.words) add(w.text, {w.token, w.payload, w.text_follows, 0});
    for (std::size_t row = 0; row < dialect.variables.size(); ++row) {
        const control::Variable& v = dialect.variables[row];
        const auto word = [&](int axis) {
            return Word{program::Token::variable, control::variable_payload(static_cast<std::uint16_t>(row), axis)};
        };
        if (!v.per_axis) add(v.name, word(-1));
        for (Axis a : all_axes)
            if (v.per_axis) add(std::string(v.name) + letter(a), word(static_cast<int>(index(a))));
    }
}

void Lexicon::add(std::string_view name, Word word) {
    std::size_t at = 0;
    for (char c : name) {
        const auto s = static_cast<std::size_t>(symbol(c));
        if (nodes_[at].next[s] == 0) {
            nodes_[at].next[s] = static_cast<std::uint16_t>(nodes_.size());
            nodes_.emplace_back();
        }
        at = nodes_[at].next[s];
    }
    word.length = static_cast<std::uint16_t>(name.size());
    nodes_[at].word = word;
}

Lexicon::Word Lexicon::longest(const char* text) const {
    Word found;
    std::size_t at = 0;
    for (const char* p = text;; ++p) {
        const int s = symbol(*p);
        if (s < 0) return found;
        at = nodes_[at].next[static_cast<std::size_t>(s)];
        if (at == 0) return found;
        if (nodes_[at].word.length) found = nodes_[at].word;
    }
}

}  // namespace fagorc::frontend
