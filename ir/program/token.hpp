// Tokens: what the scanner yields and the grammar orders.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace fagorc::program {

/// Kinds of token. The values are the bytes of a shape key, so a shape is readable and small.
/// A letter that stands alone is its own token: 'A'..'Z'. In an ISO block that is an address, between the
/// parentheses of a high-level block the name of a local parameter.
/// Outside parentheses a sign before a number belongs to the number (`X-10`); between them it is a token (`A-5` may be
/// a difference or give A the value -5: only the grammar knows).
/// Kinds from `first_with_payload` on are followed by two more key bytes, a number of 0..65535 (little end first).
enum class Token : std::uint8_t {
    end = 0,
    number = '#',         ///< a quantity: its value is a slot of the block
    text = '$',           ///< a quoted text or the text of WRITE: its span is a slot of the block
    left_parenthesis = '(', right_parenthesis = ')', comma = ',', equals = '=', plus = '+', minus = '-', times = '*',
    divide = '/', question = '?', percent = '%',
    letter_a = 'A', letter_z = 'Z',
    lower_case = 'l',     ///< first byte of a key whose block has lower-case letters outside comments and texts; a mark
                          ///< and no token: tokens are counted after it
    invalid = '!',        ///< a character that no block can hold; its span is a slot of the block

    first_with_payload = 0x80,
    g_code = 0x80,        ///< G and its digits, outside parentheses: payload = the number. With a sign, a point or too
                          ///< many digits it is the letter and a number
    m_code,               ///< M and its digits, likewise (`M0.5` is a word of a cycle, 8055 T 9)
    skip,                 ///< `/` `/1` `/2` `/3` at the start of a block: payload = the mark, 1 for a bare `/`
    // words of the high-level language, recognised by longest prefix over the control's tables
    keyword,              ///< payload = program::Keyword
    function,             ///< one-argument function: payload = program::Function1
    relation,             ///< EQ NE GT GE LT LE: payload = program::Relation
    variable,             ///< payload = index into the control's table of variables, an axis already resolved:
                          ///< index * 16 + axis + 1, or + 0 for a variable without axis
};

constexpr bool has_payload(Token t) { return t >= Token::first_with_payload; }
constexpr bool is_letter(Token t) { return t >= Token::letter_a && t <= Token::letter_z; }
constexpr Token letter_token(char c) { return static_cast<Token>(c); }

/// Keywords of the high-level languages. The grammar knows where each may stand.
enum class Keyword : std::uint16_t {
    if_, else_, goto_, rpt, sub, ret, lsub, ll, call, pcall, mcall, mdoff, probe, repos, exec, mexec, open, write,
    error, msg, dgwz, esblk, dsblk, estop, dstop, efhold, dfhold,
    page, symbol, ib, input, odw, dw, dwh, dwb, sk, wkey, wbuf, system,
    device_hd, device_dnc2, device_dnce,
    not_, and_, or_, xor_, exp, mod, arg, pi
};

/// One-argument functions (8055 T 11.4).
enum class Function1 : std::uint16_t { sin, cos, tan, asin, acos, atan, abs, log, sqrt, round, fix, fup, bcd, bin };

enum class Relation : std::uint16_t { eq, ne, gt, ge, lt, le };

/// A number or text of a block. Position and length are bytes within the block; a number keeps its text
/// (T2.2 and T2.20 are the same double and different words), and its digits are counted for format checks.
struct Quantity {
    double value = 0;              ///< a number's value with its sign; 0 for a text
    std::uint32_t at = 0;          ///< offset from the block's first byte
    std::uint16_t length = 0;
    std::uint8_t integer_digits = 0;   ///< digits before the point without leading zeros, 255 for more
    std::uint8_t decimals : 7 = 0;     ///< digits after the point
    std::uint8_t hexadecimal : 1 = 0;
};
static_assert(sizeof(Quantity) == 16);

/// A token with its place in the block, made again from the text when a diagnostic, a formatter or an editor asks.
struct PlacedToken {
    Token kind{};
    std::uint16_t payload = 0;
    std::uint32_t at = 0;
    std::uint32_t length = 0;
};

}  // namespace fagorc::program
