// Tokens of a shape key, and how messages call them.
#include <string>

#include "frontend/bind/binding.hpp"

namespace fagorc::frontend {

namespace {

using program::Token;

constexpr Text a_number{"a number", "un nombre", "un número"};
constexpr Text a_text{"a text", "un texte", "un texto"};
constexpr Text a_character{"this character", "ce caractère", "este carácter"};
constexpr Text the_end{"the end of the block", "la fin du bloc", "el final del bloque"};

}  // namespace

std::vector<syntax::Token> tokens_of(std::string_view key) {
    std::vector<syntax::Token> tokens;
    tokens.reserve(key.size());
    const auto byte = [&](std::size_t i) { return i < key.size() ? static_cast<unsigned char>(key[i]) : 0u; };
    std::uint16_t slot = 0;
    for (std::size_t i = byte(0) == static_cast<unsigned char>(Token::lower_case); i < key.size(); ++i) {
        syntax::Token t{.kind = static_cast<Token>(byte(i))};
        if (has_payload(t.kind)) {
            t.payload = static_cast<std::uint16_t>(byte(i + 1) | byte(i + 2) << 8);
            i += 2;
        } else if (t.kind == Token::number || t.kind == Token::text || t.kind == Token::invalid) {
            t.slot = slot++;
        }
        tokens.push_back(t);
    }
    return tokens;
}

diag::Argument Binding::named(std::uint32_t token) const {
    if (token >= tokens.size()) return the_end;
    const syntax::Token& t = tokens[token];
    switch (t.kind) {
        case Token::number:
            return a_number;
        case Token::text:
            return a_text;
        case Token::invalid:
            return a_character;
        case Token::skip:
            return '/';
        case Token::g_code:
        case Token::m_code: {
            const char letter = t.kind == Token::g_code ? 'G' : 'M';
            const control::Construct* c = dialect.find(letter, t.payload);
            return c ? std::string(c->code) : letter + std::to_string(t.payload);
        }
        case Token::keyword:
        case Token::function:
        case Token::relation:
            return dialect.word(t.kind, t.payload);
        case Token::variable:
            return dialect.variable_name(t.payload);
        default:
            return static_cast<char>(t.kind);
    }
}

}  // namespace fagorc::frontend
