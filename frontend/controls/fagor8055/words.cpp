// Reserved words of the 8055 T high-level language (8055 T 11.1, 11.4, 12).
#include "frontend/controls/fagor8055/fagor8055.hpp"

namespace fagorc::frontend::fagor8055 {

namespace {

using control::ReservedWord;
using program::Function1;
using program::Keyword;
using program::Relation;
using program::Token;

constexpr ReservedWord keyword(std::string_view text, Keyword k, bool text_follows = false) {
    return {text, Token::keyword, static_cast<std::uint16_t>(k), text_follows};
}
constexpr ReservedWord function(std::string_view text, Function1 f) {
    return {text, Token::function, static_cast<std::uint16_t>(f)};
}
constexpr ReservedWord relation(std::string_view text, Relation r) {
    return {text, Token::relation, static_cast<std::uint16_t>(r)};
}

constexpr ReservedWord table[] = {
    // control of the program (12.1 to 12.5)
    keyword("IF", Keyword::if_), keyword("ELSE", Keyword::else_), keyword("GOTO", Keyword::goto_),
    keyword("RPT", Keyword::rpt), keyword("SUB", Keyword::sub), keyword("RET", Keyword::ret),
    keyword("LSUB", Keyword::lsub), keyword("LL", Keyword::ll), keyword("CALL", Keyword::call),
    keyword("PCALL", Keyword::pcall), keyword("MCALL", Keyword::mcall), keyword("MDOFF", Keyword::mdoff),
    keyword("ERROR", Keyword::error),
    keyword("ERREUR", Keyword::error),  // the French manual translates this one mnemonic
    keyword("MSG", Keyword::msg), keyword("DGWZ", Keyword::dgwz), keyword("ESBLK", Keyword::esblk),
    keyword("DSBLK", Keyword::dsblk), keyword("ESTOP", Keyword::estop), keyword("DSTOP", Keyword::dstop),
    keyword("EFHOLD", Keyword::efhold), keyword("DFHOLD", Keyword::dfhold),
    // probing, interruptions, programs (12.6 to 12.8)
    keyword("PROBE", Keyword::probe), keyword("REPOS", Keyword::repos), keyword("EXEC", Keyword::exec),
    keyword("MEXEC", Keyword::mexec), keyword("OPEN", Keyword::open), keyword("WRITE", Keyword::write, true),
    keyword("HD", Keyword::device_hd), keyword("DNC2", Keyword::device_dnc2), keyword("DNCE", Keyword::device_dnce),
    // customisation programs (12.9)
    keyword("PAGE", Keyword::page), keyword("SYMBOL", Keyword::symbol), keyword("IB", Keyword::ib),
    keyword("INPUT", Keyword::input), keyword("ODW", Keyword::odw), keyword("DW", Keyword::dw),
    keyword("DWH", Keyword::dwh), keyword("DWB", Keyword::dwb), keyword("SK", Keyword::sk),
    keyword("WKEY", Keyword::wkey), keyword("WBUF", Keyword::wbuf), keyword("SYSTEM", Keyword::system),
    // operators and functions (11.4)
    keyword("NOT", Keyword::not_), keyword("AND", Keyword::and_), keyword("OR", Keyword::or_),
    keyword("XOR", Keyword::xor_), keyword("EXP", Keyword::exp), keyword("MOD", Keyword::mod),
    keyword("ARG", Keyword::arg), keyword("PI", Keyword::pi), function("SIN", Function1::sin),
    function("COS", Function1::cos), function("TAN", Function1::tan), function("ASIN", Function1::asin),
    function("ACOS", Function1::acos), function("ATAN", Function1::atan), function("ABS", Function1::abs),
    function("LOG", Function1::log), function("SQRT", Function1::sqrt), function("ROUND", Function1::round),
    function("FIX", Function1::fix), function("FUP", Function1::fup), function("BCD", Function1::bcd),
    function("BIN", Function1::bin), relation("EQ", Relation::eq), relation("NE", Relation::ne),
    relation("GT", Relation::gt), relation("GE", Relation::ge), relation("LT", Relation::lt),
    relation("LE", Relation::le)};

consteval bool each_word_once() {
    for (const ReservedWord& a : table)
        for (const ReservedWord& b : table)
            if (&a != &b && a.text == b.text) return false;
    return true;
}
static_assert(each_word_once());

}  // namespace

std::span<const ReservedWord> words() {
    return table;
}

}  // namespace fagorc::frontend::fagor8055
