#include "tools/fagorc/report/readable.hpp"

#include <algorithm>
#include <iterator>
#include <optional>

namespace fagorc::report {
namespace {

/// Characters of CP850 from 0x80 on.
constexpr std::u32string_view cp850 =
    U"ÇüéâäàåçêëèïîìÄÅÉæÆôöòûùÿÖÜø£Ø×ƒáíóúñÑªº¿®¬½¼¡«»░▒▓│┤ÁÂÀ©╣║╗╝¢¥┐└┴┬├─┼ãÃ╚╔╩╦╠═╬¤ðÐÊËÈıÍÎÏ┘┌█▄¦Ì▀"
    U"ÓßÔÒõÕµþÞÚÛÙýÝ¯´\u00AD±‗¾¶§÷¸°¨·¹³²■\u00A0";
static_assert(cp850.size() == 128);

unsigned byte(char c) {
    return static_cast<unsigned char>(c);
}

struct Decoded {
    char32_t code = 0;
    std::size_t length = 0;
};

/// The UTF-8 character at an offset; nothing where there is none (overlong forms and surrogates are none).
std::optional<Decoded> utf8_at(std::string_view s, std::size_t at) {
    const unsigned first = byte(s[at]);
    if (first < 0x80) return Decoded{first, 1};
    const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
    if (first < 0xC2 || first > 0xF4 || at + length > s.size()) return std::nullopt;
    char32_t code = first & (0x7Fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        const unsigned next = byte(s[at + i]);
        if ((next & 0xC0) != 0x80) return std::nullopt;
        code = code << 6 | (next & 0x3F);
    }
    constexpr char32_t least[] = {0, 0, 0x80, 0x800, 0x10000};
    if (code < least[length] || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return std::nullopt;
    return Decoded{code, length};
}

std::string encode(char32_t c) {
    const auto tail = [&](int shift) { return static_cast<char>(0x80 | (c >> shift & 0x3F)); };
    if (c < 0x80) return {static_cast<char>(c)};
    if (c < 0x800) return {static_cast<char>(0xC0 | c >> 6), tail(0)};
    if (c < 0x10000) return {static_cast<char>(0xE0 | c >> 12), tail(6), tail(0)};
    return {static_cast<char>(0xF0 | c >> 18), tail(12), tail(6), tail(0)};
}

/// Control characters have symbols of their own from U+2400 on; marks that turn the writing direction are replaced.
char32_t visible(char32_t c) {
    if (c == '\t') return c;
    if (c < 0x20) return 0x2400 + c;
    if (c == 0x7F) return 0x2421;
    const bool turns = (c >= 0x202A && c <= 0x202E) || (c >= 0x2066 && c <= 0x2069) || c == 0x200E || c == 0x200F;
    return (c >= 0x80 && c < 0xA0) || turns || c == 0x2028 || c == 0x2029 ? 0xFFFD : c;
}

/// Columns of a terminal. The ranges are those that look-alikes and comments of programs use, not all of Unicode.
std::size_t width_of(char32_t c) {
    struct Span {
        char32_t first, last;
    };
    static constexpr Span none[] = {{0x300, 0x36F}, {0x200B, 0x200D}, {0xFE00, 0xFE0F}, {0xFEFF, 0xFEFF}};
    static constexpr Span wide[] = {{0x1100, 0x115F}, {0x2E80, 0xA4CF},   {0xAC00, 0xD7A3},
                                    {0xF900, 0xFAFF}, {0xFE30, 0xFE6F},   {0xFF00, 0xFF60},
                                    {0xFFE0, 0xFFE6}, {0x1F300, 0x1FAFF}, {0x20000, 0x3FFFD}};
    const auto holds = [c](const Span& s) { return c >= s.first && c <= s.last; };
    if (std::any_of(std::begin(none), std::end(none), holds)) return 0;
    return std::any_of(std::begin(wide), std::end(wide), holds) ? 2 : 1;
}

enum class Encoding { utf8, latin1, pc };

Encoding encoding_of(std::string_view s) {
    for (std::size_t at = 0; at < s.size();) {
        const auto c = utf8_at(s, at);
        if (!c)
            return std::any_of(s.begin(), s.end(), [](char b) { return byte(b) >= 0x80 && byte(b) < 0xA0; })
                       ? Encoding::pc
                       : Encoding::latin1;
        at += c->length;
    }
    return Encoding::utf8;
}

Decoded decode(std::string_view s, std::size_t at, Encoding encoding) {
    if (encoding == Encoding::utf8) return *utf8_at(s, at);
    const unsigned b = byte(s[at]);
    return {encoding == Encoding::pc && b >= 0x80 ? cp850[b - 0x80] : char32_t{b}, 1};
}

/// Calls `take` with each character and the offset of its first byte.
template <class Take>
void each(std::string_view bytes, Take take) {
    const Encoding encoding = encoding_of(bytes);
    for (std::size_t at = 0; at < bytes.size();) {
        const Decoded c = decode(bytes, at, encoding);
        take(c.code, at);
        at += c.length;
    }
}

}  // namespace

std::vector<Cell> cells(std::string_view bytes) {
    std::vector<Cell> out;
    out.reserve(bytes.size());
    each(bytes, [&](char32_t code, std::size_t at) {
        const char32_t shown = visible(code);
        out.push_back({encode(shown), width_of(shown), at, code});
    });
    return out;
}

std::string readable(std::string_view bytes) {
    std::string out;
    each(bytes, [&](char32_t code, std::size_t) { out += encode(visible(code)); });
    return out;
}

std::size_t code_points_before(std::string_view bytes, std::size_t offset) {
    std::size_t count = 0;
    each(bytes, [&](char32_t, std::size_t at) { count += at < offset ? 1 : 0; });
    return count + (offset > bytes.size() ? offset - bytes.size() : 0);
}

}  // namespace fagorc::report
