#include "frontend/scan/scanner.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstring>
#include <string>

#include "frontend/scan/quantity.hpp"

namespace fagorc::frontend {
namespace {

using program::PlacedToken;
using program::Quantity;
using program::Token;

enum class Kind : std::uint8_t {
    other,
    end,
    blank,
    letter,
    code,  ///< G or M: a letter whose digits name something
    digit,
    sign,
    quote,
    comment,
    symbol,
    open,
    close,
    slash,
    dollar
};

constexpr std::array<Kind, 256> make_kinds() {
    std::array<Kind, 256> k{};
    for (int c = 0; c < 256; ++c) {
        const char ch = static_cast<char>(c);
        k[c] = ch == 'G' || ch == 'g' || ch == 'M' || ch == 'm'       ? Kind::code
               : (ch >= 'A' && ch <= 'Z') || (ch >= 'a' && ch <= 'z') ? Kind::letter
               : (ch >= '0' && ch <= '9') || ch == '.'                ? Kind::digit
               : ch == ' ' || ch == '\t' || ch == '\0'                ? Kind::blank
               : ch == '\r' || ch == '\n'                             ? Kind::end
               : ch == '+' || ch == '-'                               ? Kind::sign
               : ch == '=' || ch == ',' || ch == '*' || ch == '?'     ? Kind::symbol
               : ch == '('                                            ? Kind::open
               : ch == ')'                                            ? Kind::close
               : ch == '/'                                            ? Kind::slash
               : ch == '"'                                            ? Kind::quote
               : ch == ';'                                            ? Kind::comment
               : ch == '$'                                            ? Kind::dollar
                                                                      : Kind::other;
    }
    return k;
}
constexpr std::array<Kind, 256> kinds = make_kinds();

Kind kind(char c) {
    return kinds[static_cast<unsigned char>(c)];
}
bool is_letter(Kind k) {
    return k == Kind::letter || k == Kind::code;
}
bool is_digit(char c) {
    return c >= '0' && c <= '9';
}
char upper(char c) {
    return static_cast<char>(c & ~0x20);
}
const char* skip_blanks(const char* p) {
    while (kind(*p) == Kind::blank) ++p;
    return p;
}

const char* line_end(const char* p) {
    while (kind(*p) != Kind::end) ++p;
    return p;
}
/// Offset from `text` of what follows a line end: CR, LF, or CR LF.
std::size_t behind(const char* end, const char* text) {
    return static_cast<std::size_t>(end - text) + (end[0] == '\r' && end[1] == '\n' ? 2 : 1);
}

/// Bytes of the character at p: a whole UTF-8 sequence where the bytes are one, else 1.
std::size_t character_length(const char* p) {
    const auto lead = static_cast<unsigned char>(*p);
    const std::size_t n = lead >= 0xF0 && lead < 0xF5   ? 4
                          : lead >= 0xE0 && lead < 0xF0 ? 3
                          : lead >= 0xC2 && lead < 0xE0 ? 2
                                                        : 1;
    for (std::size_t i = 1; i < n; ++i)
        if ((static_cast<unsigned char>(p[i]) & 0xC0) != 0x80) return 1;
    return n;
}

/// The end of a WRITE text: the parenthesis that closes the block, quotes honoured; the line's end where there is none.
const char* end_of_text(const char* p) {
    bool quoted = false;
    for (int depth = 0; kind(*p) != Kind::end; ++p) {
        if (*p == '"') quoted = !quoted;
        if (quoted) continue;
        if (*p == '(') ++depth;
        if (*p == ')' && depth-- == 0) break;
    }
    return p;
}

/// One block on its way through the scanner.
template <bool Placed>
class Run {
  public:
    Run(const char* text, std::size_t limit, const Lexicon& lexicon, char* key, Quantity* slots,
        std::vector<PlacedToken>* placed)
        : begin_(text), limit_(text + limit), lexicon_(lexicon), key_(key), slots_(slots), placed_(placed) {}

    /// Scans up to the line end and returns it, or the first token beyond the limit: the room for keys and slots holds.
    const char* run() {
        for (;;) {
            p_ = skip_blanks(p_);
            if (p_ > limit_) return p_;
            switch (kind(*p_)) {
                case Kind::end:
                    return p_;
                case Kind::letter:
                case Kind::code:
                    depth_ ? word() : words();
                    break;
                case Kind::digit:
                    number(p_, false, p_);
                    break;
                case Kind::sign:
                    sign();
                    break;
                case Kind::comment:
                    p_ = line_end(p_);
                    break;
                case Kind::open:
                    ++depth_, symbol();
                    break;
                case Kind::close:
                    depth_ -= depth_ > 0, symbol();
                    break;
                case Kind::symbol:
                    symbol();
                    break;
                case Kind::slash:
                    depth_ ? symbol() : skip_mark();
                    break;
                case Kind::quote:
                    quoted();
                    break;
                case Kind::dollar:
                    depth_ ? hexadecimal() : strange();
                    break;
                default:
                    strange();
                    break;
            }
        }
    }
    char* key() const { return key_; }
    Quantity* slots() const { return slots_; }
    bool lower_case() const { return (letters_ & 0x20) != 0; }

  private:
    void token(Token t, const char* from, const char* to) {
        *key_++ = static_cast<char>(t);
        if constexpr (Placed) place(t, 0, from, to);
        p_ = to;
    }
    void token(Token t, std::uint16_t payload, const char* from, const char* to) {
        *key_++ = static_cast<char>(t);
        *key_++ = static_cast<char>(payload & 0xff);
        *key_++ = static_cast<char>(payload >> 8);
        if constexpr (Placed) place(t, payload, from, to);
        p_ = to;
    }
    void place(Token t, std::uint16_t payload, const char* from, const char* to) {
        placed_->push_back(
            {t, payload, static_cast<std::uint32_t>(from - begin_), static_cast<std::uint32_t>(to - from)});
    }
    void slot(Quantity q, const char* from, const char* to) {
        *slots_ = q;
        place_slot(from, to);
    }
    /// Gives the quantity that was written into the next slot its place.
    void place_slot(const char* from, const char* to) {
        slots_->at = static_cast<std::uint32_t>(from - begin_);
        slots_->length = static_cast<std::uint16_t>(to - from);
        ++slots_;
    }
    void symbol() { token(static_cast<Token>(*p_), p_, p_ + 1); }

    /// A number whose digits start at `digits`; `from` is its sign when that belongs to it.
    void number(const char* digits, bool negative, const char* from) {
        const char* to = read_quantity(digits, negative, *slots_);
        if (to == digits) return invalid(digits + 1);  // a point alone
        place_slot(from, to);
        token(Token::number, from, to);
    }

    /// In an ISO block a sign belongs to the number that follows (8055 T 2: M19 S -30).
    void sign() {
        const char* digits = depth_ ? p_ : skip_blanks(p_ + 1);
        if (kind(*digits) == Kind::digit) return number(digits, *p_ == '-', p_);
        symbol();
    }

    /// The words of an ISO block, mostly all of it.
    void words() {
        do {
            letters_ |= *p_;
            kind(*p_) == Kind::code ? code(upper(*p_)) : address(upper(*p_));
            p_ = skip_blanks(p_);
        } while (p_ <= limit_ && is_letter(kind(*p_)));
    }

    /// A letter; most are followed by a number at once.
    void address(char c) {
        token(program::letter_token(c), p_, p_ + 1);
        const char* const from = p_;
        if (kind(*from) == Kind::digit)
            number(from, false, from);
        else if (*from == '-' && kind(from[1]) == Kind::digit)
            number(from + 1, true, from);
    }

    /// G or M: the digits name something, so they stay in the key; none are 0 (8055 T 2). `GP1` takes them from a
    /// parameter and stays a letter.
    void code(char c) {
        const char* from = p_;
        const char* p = skip_blanks(p_ + 1);
        const bool bare = is_letter(kind(*p)) && upper(*p) != 'P';
        if (!is_digit(*p) && !bare && kind(*p) != Kind::end && kind(*p) != Kind::comment)
            return token(program::letter_token(c), from, from + 1);
        std::uint32_t value = 0;
        const char* to = from + 1;
        for (; is_digit(*p); p = skip_blanks(p)) {
            value = value * 10 + static_cast<std::uint32_t>(*p++ - '0');
            if (value > 0xffff) value = 0xffff;  // beyond every table
            to = p;
        }
        if (*p == '.') return token(program::letter_token(c), from, from + 1);  // M0.5: an operand of a cycle
        token(c == 'G' ? Token::g_code : Token::m_code, static_cast<std::uint16_t>(value), from, to);
    }

    void skip_mark() {
        const char* digit = skip_blanks(p_ + 1);
        const bool numbered = is_digit(*digit) && !is_digit(digit[1]);
        token(Token::skip, static_cast<std::uint16_t>(numbered ? *digit - '0' : 1), p_, numbered ? digit + 1 : p_ + 1);
    }

    void word() {
        const char* from = p_;
        const Lexicon::Word w = lexicon_.longest(from);
        const std::size_t length = w.length ? w.length : 1;
        for (std::size_t i = 0; i < length; ++i) letters_ |= is_letter(kind(from[i])) ? from[i] : 0;
        if (!w.length) return token(program::letter_token(upper(*from)), from, from + 1);
        token(w.token, w.payload, from, from + length);
        if (!w.text_follows) return;
        const char* text = skip_blanks(p_);
        const char* to = end_of_text(text);
        slot({}, text, to);
        token(Token::text, text, to);
    }

    void quoted() {
        const char* to = p_ + 1;
        while (*to != '"' && kind(*to) != Kind::end) ++to;
        if (*to != '"') return invalid(to);
        slot({}, p_ + 1, to);
        token(Token::text, p_, to + 1);
    }

    /// `$` and up to eight hexadecimal digits, taken greedily; ISO blocks have none (8055 T 11.3).
    void hexadecimal() {
        std::uint32_t value = 0;
        const auto [to, error] = std::from_chars(p_ + 1, p_ + 9, value, 16);
        if (error != std::errc{}) return strange();
        for (const char* p = p_; p < to; ++p) letters_ |= is_letter(kind(*p)) ? *p : 0;
        Quantity q;
        q.value = value;
        q.hexadecimal = 1;
        slot(q, p_, to);
        token(Token::number, p_, to);
    }

    void strange() {
        if (*p_ == '%') return token(Token::percent, p_, line_end(p_));
        invalid(p_ + character_length(p_));
    }
    void invalid(const char* to) {
        slot({}, p_, to);
        token(Token::invalid, p_, to);
    }

    const char* begin_;
    const char* p_ = begin_;
    const char* limit_;
    const Lexicon& lexicon_;
    char* key_;
    Quantity* slots_;
    std::vector<PlacedToken>* placed_;
    int depth_ = 0;
    int letters_ = 0;  ///< bits of all letters: 0x20 is that of lower case
};

}  // namespace

// A key byte and a slot are at most one each for a byte of the block; two payload bytes come with a word.
// The room is reserved, not touched: a program of short blocks takes one page of it.
Scan::Scan(std::size_t block_bytes)
    : key_(new char[3 * block_bytes + 64]),
      slots_(std::allocator<Quantity>().allocate(block_bytes + 64), Release{block_bytes + 64}) {}

void Scan::Release::operator()(Quantity* slots) const {
    std::allocator<Quantity>().deallocate(slots, count);
}

Scanner::Scanner(const control::Dialect& dialect) : lexicon_(dialect), block_bytes_(dialect.limits.block_bytes) {}

template <bool Placed>
Scanner::Extent Scanner::run(const char* text, Scan& out, std::vector<PlacedToken>* placed) const {
    // The first key byte is kept free for the mark of lower-case letters, which is known only at the end.
    char* const key = out.key_.get();
    Run<Placed> run(text, block_bytes_, lexicon_, key + 1, out.slots_.get(), placed);
    const char* end = run.run();
    if (static_cast<std::size_t>(end - text) > block_bytes_) {
        end = line_end(end);
        return {static_cast<std::size_t>(end - text), behind(end, text), true};
    }
    *key = static_cast<char>(Token::lower_case);
    out.key_begin_ = run.lower_case() ? key : key + 1;
    out.key_size_ = static_cast<std::size_t>(run.key() - out.key_begin_);
    out.slot_count_ = static_cast<std::size_t>(run.slots() - out.slots_.get());
    return {static_cast<std::size_t>(end - text), behind(end, text), false};
}

Scanner::Extent Scanner::scan(const char* text, Scan& out) const {
    return run<false>(text, out, nullptr);
}

std::vector<PlacedToken> Scanner::tokens(const char* text, Scan& room) const {
    std::vector<PlacedToken> all;
    if (run<true>(text, room, &all).too_long) all.clear();
    return all;
}

}  // namespace fagorc::frontend
