#include "passes/execute/texts.hpp"

#include <array>
#include <charconv>

#include "ir/base/axis.hpp"

namespace fagorc::passes {
namespace {

constexpr int decimals = 5;

bool is_digit(char c) {
    return c >= '0' && c <= '9';
}

std::size_t skip_blanks(std::string_view text, std::size_t at) {
    while (at < text.size() && text[at] == ' ') ++at;
    return at;
}

/// The number behind a P at `at`, and where it ends; nothing when no digit follows.
struct Reference {
    double number = 0;
    std::size_t end = 0;
};
std::optional<Reference> reference(std::string_view text, std::size_t at) {
    if (at >= text.size() || text[at] != 'P') return std::nullopt;
    Reference r{0, skip_blanks(text, at + 1)};
    const std::size_t first = r.end;
    for (; r.end < text.size() && is_digit(text[r.end]); ++r.end) r.number = 10 * r.number + (text[r.end] - '0');
    return r.end == first ? std::nullopt : std::optional(r);
}

/// The last character before `at` that is no blank; 0 where there is none.
char before(std::string_view text, std::size_t at) {
    while (at > 0 && text[at - 1] == ' ') --at;
    return at == 0 ? '\0' : text[at - 1];
}

}  // namespace

std::string written(double value) {
    std::array<char, 400> digits;  // NOLINT: to_chars fills it; the largest double has 309 digits
    const auto end =
        std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals).ptr;
    std::string text(digits.data(), end);
    text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text == "-0" ? "0" : text;
}

std::optional<std::string> with_marked_values(std::string_view text, const ParameterValue& value) {
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        const auto r = text[i] == '?' ? reference(text, i + 1) : std::nullopt;
        if (!r) {
            out += text[i++];
            continue;
        }
        const auto v = value(r->number);
        if (!v) return std::nullopt;
        out += written(*v);
        i = r->end;
    }
    return out;
}

std::optional<std::string> written_block(std::string_view text, const ParameterValue& value) {
    if (const std::size_t first = skip_blanks(text, 0); first < text.size() && text[first] == '(')
        return with_marked_values(text, value);
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        if (text[i] == '$') {
            const auto literal = reference(text, i + 1);
            if (!literal || !axis_of(before(text, i))) out += '$';
            ++i;
            if (!literal) {  // `$ P100` is $ and the value, `$3000` stays
                if (const std::size_t p = skip_blanks(text, i); reference(text, p)) i = p;
                continue;
            }
            out.append(text, i, literal->end - i);
            i = literal->end;
            continue;
        }
        const std::size_t mark = text[i] == '?' ? 1 : 0;
        const auto r = reference(text, i + mark);
        if (!r) {
            out += text[i++];
            continue;
        }
        const auto v = value(r->number);
        if (!v) return std::nullopt;
        out += written(*v);
        i = r->end;
    }
    return out;
}

}  // namespace fagorc::passes
