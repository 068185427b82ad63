#include "ir/program/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <tuple>
#include <variant>

#include "ir/diag/catalogue.hpp"

namespace fagorc::program {
namespace {

struct Known {
    char32_t code;
    CharacterName is;
};

// What text editors, web pages and input methods put in place of the characters of a program.
constexpr Known known[] = {
    {0x00A0, {{"a no-break space", "une espace insécable", "un espacio de no separación"}, ' '}},
    {0x202F, {{"a narrow no-break space", "une espace fine insécable", "un espacio fino de no separación"}, ' '}},
    {0x2007, {{"a figure space", "une espace tabulaire", "un espacio de cifra"}, ' '}},
    {0x2009, {{"a thin space", "une espace fine", "un espacio fino"}, ' '}},
    {0x200B, {{"a zero-width space", "une espace sans chasse", "un espacio de ancho cero"}, ' '}},
    {0x3000, {{"an ideographic space", "une espace idéographique", "un espacio ideográfico"}, ' '}},
    {0xFEFF, {{"a byte order mark", "une marque d'ordre des octets", "una marca de orden de bytes"}, 0}},
    {0x00AD, {{"a soft hyphen", "un trait d'union conditionnel", "un guion opcional"}, '-'}},
    {0x2010, {{"a typographic hyphen", "un trait d'union typographique", "un guion tipográfico"}, '-'}},
    {0x2011, {{"a no-break hyphen", "un trait d'union insécable", "un guion de no separación"}, '-'}},
    {0x2012, {{"a figure dash", "un tiret numérique", "una raya de cifra"}, '-'}},
    {0x2013, {{"an en dash", "un tiret demi-cadratin", "una semirraya"}, '-'}},
    {0x2014, {{"an em dash", "un tiret cadratin", "una raya"}, '-'}},
    {0x2212, {{"a typographic minus sign", "un signe moins typographique", "un signo menos tipográfico"}, '-'}},
    {0x2018, {{"a left single quotation mark", "une apostrophe ouvrante", "una comilla simple de apertura"}, 0}},
    {0x2019, {{"a right single quotation mark", "une apostrophe typographique", "una comilla simple de cierre"}, 0}},
    {0x201C, {{"a left double quotation mark", "un guillemet anglais ouvrant", "unas comillas de apertura"}, '"'}},
    {0x201D, {{"a right double quotation mark", "un guillemet anglais fermant", "unas comillas de cierre"}, '"'}},
    {0x00D7, {{"a multiplication sign", "un signe multiplié", "un signo de multiplicación"}, '*'}},
    {0x00F7, {{"a division sign", "un signe divisé", "un signo de división"}, '/'}},
    {0x2215, {{"a division slash", "une barre de division", "una barra de división"}, '/'}},
    {0x2044, {{"a fraction slash", "une barre de fraction", "una barra de fracción"}, '/'}},
    {0x0410, {{"a Cyrillic A", "un A cyrillique", "una A cirílica"}, 'A'}},
    {0x0412, {{"a Cyrillic Ve", "un Vé cyrillique", "una Ve cirílica"}, 'B'}},
    {0x0421, {{"a Cyrillic Es", "un S cyrillique", "una Ese cirílica"}, 'C'}},
    {0x041C, {{"a Cyrillic Em", "un M cyrillique", "una Eme cirílica"}, 'M'}},
    {0x0425, {{"a Cyrillic Kha", "un Kha cyrillique", "una Ja cirílica"}, 'X'}},
};

constexpr CharacterName fullwidth_digit{
    {"a fullwidth digit", "un chiffre pleine chasse", "un dígito de ancho completo"}, 0};
constexpr CharacterName fullwidth_letter{
    {"a fullwidth letter", "une lettre pleine chasse", "una letra de ancho completo"}, 0};

/// The code point of one UTF-8 sequence or one Latin-1 byte; 0 for nothing.
char32_t code_point(std::string_view bytes) {
    if (bytes.empty()) return 0;
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(bytes[i]); };
    if (bytes.size() == 1) return byte(0);
    char32_t code = byte(0) & (0xFFu >> (bytes.size() + 1));
    for (std::size_t i = 1; i < bytes.size(); ++i) code = code << 6 | (byte(i) & 0x3Fu);
    return code;
}

/// `{0}` of strange_character: the name, or the bytes.
diag::Argument shown(std::string_view bytes, const CharacterName* name) {
    if (name) return name->name;
    const auto first = static_cast<unsigned char>(bytes.front());
    if (bytes.size() == 1 && first > 0x20 && first < 0x7f) return fmt::format("'{}'", bytes);
    std::string hexadecimal;
    for (char c : bytes)
        hexadecimal += fmt::format("{}{:02X}", hexadecimal.empty() ? "" : " ", static_cast<unsigned char>(c));
    return hexadecimal;
}

diag::Diagnostic strange_character(const diag::Place& place, std::string_view bytes) {
    if (bytes.starts_with('"')) return {diag::Id::text_not_closed, place, {}, {}};
    const CharacterName* name = name_of_character(bytes);
    const char32_t code = code_point(bytes);
    const bool fullwidth = code >= 0xFF01 && code <= 0xFF5E;
    const char ascii = fullwidth ? static_cast<char>(code - 0xFEE0) : name ? name->looks_like : '\0';
    if (!ascii) return {diag::Id::strange_character, place, {shown(bytes, name)}, {}};
    static constexpr Text blank{"a blank", "une espace", "un espacio"};
    return {diag::Id::look_alike_character,
            place,
            {name->name, ascii == ' ' ? diag::Argument(blank) : diag::Argument(ascii)},
            {}};
}

std::string_view text_of(const Block& block, const PlacedToken& token) {
    return block.text.substr(std::min<std::size_t>(token.at, block.text.size()), token.length);
}

bool is_lower(char c) {
    return c >= 'a' && c <= 'z';
}

/// The first word with lower-case letters; texts may hold them.
std::optional<diag::Diagnostic> lower_case(Program& program, const Block& block) {
    const auto tokens = program.tokens(block);
    for (std::uint32_t i = 0; i < tokens.size(); ++i) {
        if (tokens[i].kind == Token::text || tokens[i].kind == Token::invalid) continue;
        const std::string_view word = text_of(block, tokens[i]);
        if (std::any_of(word.begin(), word.end(), is_lower))
            return diag::Diagnostic{diag::Id::lower_case_word, program.place(block, i, i + 1), {word}, {}};
    }
    return std::nullopt;
}

/// Assignments to one destination count as one (8055 T 12.1). What an index computes is not known here, so each of
/// those is a destination of its own.
std::size_t destinations(const Block& block, const Assign& assign) {
    std::set<std::tuple<Target::Kind, std::uint16_t, double, std::uint16_t>> all;
    for (const Assignment& a : assign.list) {
        const Target& t = a.target;
        const double number = t.kind == Target::Kind::parameter ? block.slots[t.slot].value : 0;
        all.emplace(t.kind, t.operand, number, t.index.present() ? t.token : std::uint16_t{0});
    }
    return all.size();
}

}  // namespace

const CharacterName* name_of_character(std::string_view bytes) {
    const char32_t code = code_point(bytes);
    if (code >= 0xFF10 && code <= 0xFF19) return &fullwidth_digit;
    if (code >= 0xFF01 && code <= 0xFF5E) return &fullwidth_letter;
    for (const Known& k : known)
        if (k.code == code) return &k.is;
    return nullptr;
}

std::optional<diag::Diagnostic> diagnostic_of(Program& program, const Block& block, const Finding& finding) {
    using diag::Id;
    if (finding.id == Id::lower_case_word) return lower_case(program, block);
    if (finding.id == Id::empty_block && block.text.find(';') != std::string_view::npos) return std::nullopt;
    if (finding.id == Id::too_many_assignments) {
        const auto* s = std::get_if<Statement>(&block.shape->body);
        const auto* assign = s ? std::get_if<Assign>(&s->what) : nullptr;
        if (assign && destinations(block, *assign) <= finding.limit) return std::nullopt;
    }
    const diag::Place place = program.place(block, finding.token, finding.end_token);
    if (finding.id == Id::strange_character) {
        const auto tokens = program.tokens(block);
        if (finding.token < tokens.size()) return strange_character(place, text_of(block, tokens[finding.token]));
    }
    diag::Diagnostic d{finding.id, place, finding.arguments, {}};
    // The key of a shape holds no number above 65535: the word is shown as it is written.
    if (finding.id == Id::unknown_g || finding.id == Id::unknown_misc) {
        const auto tokens = program.tokens(block);
        if (finding.token < tokens.size()) d.arguments.front() = text_of(block, tokens[finding.token]);
    }
    return d;
}

bool report_findings(Program& program, const Block& block, diag::Sink& out) {
    bool error = false;
    for (const Finding& f : block.shape->findings) {
        auto d = diagnostic_of(program, block, f);
        if (!d) continue;
        error = error || diag::row(d->id).severity == diag::Severity::error;
        out.report(std::move(*d));
    }
    return error;
}

}  // namespace fagorc::program
