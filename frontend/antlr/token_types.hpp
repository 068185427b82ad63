// The terminals of the grammar for the tokens of a key, and the places of the grammar that a message distinguishes.
// Only block_parser.cpp includes this file.
#pragma once

#include <Fagor8055.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <initializer_list>

#include "frontend/bind/syntax.hpp"
#include "ir/control/dialect.hpp"

namespace fagorc::frontend {

namespace terminals {

using T = grammar::Fagor8055;
using enum program::Keyword;

/// By the value of the keyword: one terminal for all words of the same form.
inline constexpr auto by_keyword = [] {
    std::array<std::size_t, static_cast<std::size_t>(pi) + 1> all{};
    const auto put = [&](std::size_t terminal, std::initializer_list<program::Keyword> words) {
        for (const program::Keyword w : words) all[static_cast<std::size_t>(w)] = terminal;
    };
    put(T::IF, {if_});
    put(T::ELSE, {else_});
    put(T::GOTO, {goto_});
    put(T::RPT, {rpt});
    put(T::SUB, {sub, lsub});
    put(T::CALL, {ll, call, pcall, mcall, probe});
    put(T::EXEC, {exec, mexec});
    put(T::OPEN, {open});
    put(T::REPOS, {repos});
    put(T::ERROR, {error});
    put(T::ONE_TEXT, {write, msg});
    put(T::OPERANDS, {dgwz, page, symbol, odw});
    put(T::ALONE, {ret, mdoff, esblk, dsblk, estop, dstop, efhold, dfhold, wkey, system});
    put(T::DEVICE, {device_hd, device_dnc2, device_dnce});
    put(T::IB, {ib});
    put(T::INPUT, {input});
    put(T::WINDOW, {dw, dwh, dwb});
    put(T::SK, {sk});
    put(T::WBUF, {wbuf});
    put(T::NOT, {not_});
    put(T::AND, {and_});
    put(T::OR, {or_});
    put(T::XOR, {xor_});
    put(T::EXP, {exp});
    put(T::MOD, {mod});
    put(T::ARG, {arg});
    put(T::PI, {pi});
    return all;
}();
static_assert(std::find(by_keyword.begin(), by_keyword.end(), std::size_t{0}) == by_keyword.end(),
              "a keyword without a terminal");

/// By the value of the token, where no table decides.
inline constexpr auto by_token = [] {
    using program::Token;
    std::array<std::size_t, 256> all{};
    all.fill(T::OTHER);
    const auto put = [&](std::size_t terminal, Token kind) { all[static_cast<std::size_t>(kind)] = terminal; };
    for (char c = 'A'; c <= 'Z'; ++c) put(T::LETTER, program::letter_token(c));
    put(T::LETTER_N, program::letter_token('N'));
    put(T::LETTER_P, program::letter_token('P'));
    put(T::NUMBER, Token::number);
    put(T::TEXT, Token::text);
    put(T::LEFT, Token::left_parenthesis);
    put(T::RIGHT, Token::right_parenthesis);
    put(T::COMMA, Token::comma);
    put(T::EQUALS, Token::equals);
    put(T::PLUS, Token::plus);
    put(T::MINUS, Token::minus);
    put(T::TIMES, Token::times);
    put(T::DIVIDE, Token::divide);
    put(T::SKIP_MARK, Token::skip);
    put(T::M_CODE, Token::m_code);
    put(T::FUNCTION, Token::function);
    put(T::RELATION, Token::relation);
    return all;
}();

}  // namespace terminals

/// The terminal of a token, by the control's tables where its form depends on them.
class TokenTypes {
  public:
    explicit TokenTypes(const control::Dialect& dialect) : dialect_(dialect) {}

    std::size_t of(const syntax::Token& t) const {
        switch (t.kind) {
            case program::Token::g_code:
                return code(t.payload);
            case program::Token::variable:
                return variable(t.payload);
            case program::Token::keyword:
                if (t.payload >= terminals::by_keyword.size()) return terminals::T::OTHER;
                return terminals::by_keyword[t.payload];
            default:
                return terminals::by_token[static_cast<std::size_t>(t.kind)];
        }
    }

  private:
    std::size_t code(std::uint16_t number) const {
        const control::Construct* c = dialect_.find('G', number);
        return c && c->takes == control::Takes::arguments ? grammar::Fagor8055::G_CALL : grammar::Fagor8055::G_CODE;
    }
    std::size_t variable(std::uint16_t payload) const {
        using T = grammar::Fagor8055;
        const std::uint16_t row = control::variable_row(payload);
        if (row >= dialect_.variables.size()) return T::OTHER;
        switch (dialect_.variables[row].index) {
            case control::IndexForm::none:
                return T::VARIABLE;
            case control::IndexForm::required:
                return T::INDEXED_VARIABLE;
            case control::IndexForm::optional:
                return T::TABLE_VARIABLE;
            case control::IndexForm::label_and_program:
                return T::POSITION_VARIABLE;
        }
        return T::OTHER;
    }

    const control::Dialect& dialect_;
};

}  // namespace fagorc::frontend
