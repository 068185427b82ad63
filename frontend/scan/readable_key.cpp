#include "frontend/scan/readable_key.hpp"

#include <fmt/format.h>

namespace fagorc::frontend {
namespace {

using program::Token;

std::string word(Token t, std::uint16_t payload, const control::Dialect& dialect) {
    switch (t) {
        case Token::g_code:
            return fmt::format("G{}", payload);
        case Token::m_code:
            return fmt::format("M{}", payload);
        case Token::skip:
            return fmt::format("/{}", payload);
        case Token::variable:
            return dialect.variable_name(payload);
        default:
            return std::string(dialect.word(t, payload));
    }
}

}  // namespace

std::string readable_key(std::string_view key, const control::Dialect& dialect) {
    std::string out;
    for (std::size_t i = 0; i < key.size(); ++i) {
        const auto t = static_cast<Token>(static_cast<unsigned char>(key[i]));
        if (!out.empty()) out += ' ';
        if (!program::has_payload(t)) {
            out += key[i];
            continue;
        }
        const auto byte = [&](std::size_t n) { return static_cast<unsigned char>(key[i + n]); };
        out += word(t, static_cast<std::uint16_t>(byte(1) | byte(2) << 8), dialect);
        i += 2;
    }
    return out;
}

}  // namespace fagorc::frontend
