// The terminals of the grammar for the tokens of a key, and the places of the grammar that a message distinguishes.
// Only block_parser.cpp includes this file.
#pragma once

#include <Fagor8055.h>

#include <array>
#include <cstddef>

#include "frontend/bind/syntax.hpp"
#include "ir/control/dialect.hpp"

namespace fagorc::frontend {

/// The terminal of each keyword: one for all words of the same form.
constexpr std::size_t terminal(program::Keyword word) {
    using T = grammar::Fagor8055;
    using enum program::Keyword;
    switch (word) {
        case if_:
            return T::IF;
        case else_:
            return T::ELSE;
        case goto_:
            return T::GOTO;
        case rpt:
            return T::RPT;
        case sub:
        case lsub:
            return T::SUB;
        case ll:
        case call:
        case pcall:
        case mcall:
        case probe:
            return T::CALL;
        case ret:
        case mdoff:
        case wkey:
        case system:
            return T::ALONE;
        case esblk:
        case dsblk:
        case estop:
        case dstop:
        case efhold:
        case dfhold:
            return T::ALONE;
        case repos:
            return T::REPOS;
        case exec:
        case mexec:
            return T::EXEC;
        case open:
            return T::OPEN;
        case write:
        case msg:
            return T::ONE_TEXT;
        case error:
            return T::ERROR;
        case dgwz:
        case page:
        case symbol:
        case odw:
            return T::OPERANDS;
        case ib:
            return T::IB;
        case input:
            return T::INPUT;
        case dw:
        case dwh:
        case dwb:
            return T::WINDOW;
        case sk:
            return T::SK;
        case wbuf:
            return T::WBUF;
        case device_hd:
        case device_dnc2:
        case device_dnce:
            return T::DEVICE;
        case not_:
            return T::NOT;
        case and_:
            return T::AND;
        case or_:
            return T::OR;
        case xor_:
            return T::XOR;
        case exp:
            return T::EXP;
        case mod:
            return T::MOD;
        case arg:
            return T::ARG;
        case pi:
            return T::PI;
    }
    return T::OTHER;
}

/// The terminal of a token, by the control's tables where its form depends on them.
class TokenTypes {
  public:
    explicit TokenTypes(const control::Dialect& dialect) : dialect_(dialect) {}

    std::size_t of(const syntax::Token& t) const {
        using T = grammar::Fagor8055;
        using program::Token;
        if (is_letter(t.kind))
            return t.kind == program::letter_token('N')   ? T::LETTER_N
                   : t.kind == program::letter_token('P') ? T::LETTER_P
                                                          : T::LETTER;
        switch (t.kind) {
            case Token::number:
                return T::NUMBER;
            case Token::text:
                return T::TEXT;
            case Token::left_parenthesis:
                return T::LEFT;
            case Token::right_parenthesis:
                return T::RIGHT;
            case Token::comma:
                return T::COMMA;
            case Token::equals:
                return T::EQUALS;
            case Token::plus:
                return T::PLUS;
            case Token::minus:
                return T::MINUS;
            case Token::times:
                return T::TIMES;
            case Token::divide:
                return T::DIVIDE;
            case Token::skip:
                return T::SKIP_MARK;
            case Token::m_code:
                return T::M_CODE;
            case Token::g_code:
                return code(t.payload);
            case Token::keyword:
                return terminal(static_cast<program::Keyword>(t.payload));
            case Token::function:
                return T::FUNCTION;
            case Token::relation:
                return T::RELATION;
            case Token::variable:
                return variable(t.payload);
            default:
                return T::OTHER;
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
