// fagorc explain: what a finding, a code, a statement or a variable means, from the catalogue and the tables.
#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>
#include <utility>

#include "frontend/controls/controls.hpp"
#include "ir/control/describe.hpp"
#include "ir/diag/alarm.hpp"
#include "ir/diag/catalogue.hpp"
#include "ir/diag/explain.hpp"
#include "tools/fagorc/commands.hpp"
#include "tools/fagorc/console.hpp"

namespace fagorc::tool {
namespace {

struct Options {
    Settings settings;
    std::string word;
};

constexpr Text planned{"known, not yet supported", "connu, pas encore pris en charge", "conocido, aún no se admite"};
constexpr Text example{"Example:", "Exemple :", "Ejemplo:"};
constexpr Text raises{"Raises it:", "La déclenche :", "La provoca:"};
constexpr Text does_not{"Is right:", "Est correct :", "Es correcto:"};
constexpr Text read_only{"read only", "lecture seule", "solo lectura"};
constexpr Text stops{"stops block preparation", "arrête la préparation des blocs", "detiene la preparación de bloques"};

std::string upper(std::string text) {
    for (char& c : text)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return text;
}

std::string indented(std::string_view text) {
    std::string out = "    ";
    for (char c : text) out += c == '\n' ? "\n    " : std::string(1, c);
    return out + '\n';
}

std::string_view trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of('\n');
    return first == text.npos ? std::string_view{} : text.substr(first, text.find_last_not_of('\n') + 1 - first);
}

/// A message with dots in the place of its values {0}, {1} ...
std::string without_values(std::string_view message) {
    std::string out(message);
    for (std::size_t i = 0; (i = out.find('{', i)) != out.npos;) out.replace(i, out.find('}', i) + 1 - i, "...");
    return out;
}

std::string operands(std::span<const control::Operand> list, Language l) {
    std::string out;
    for (const control::Operand& o : list) {
        const std::string letter = o.address == control::any_axis ? "X..C" : std::string(1, o.address);
        std::string details(control::describe(o.role).in(l));
        if (const std::string range = control::to_string(o.range); !range.empty()) details += ", " + range;
        if (const auto need = control::describe(o.need).in(l); !need.empty()) details += fmt::format(", {}", need);
        out += fmt::format("  {:5} {}{}\n", letter, o.text.in(l), details.empty() ? "" : " (" + details + ")");
    }
    return out;
}

std::string head(std::string_view word, Text title, std::string_view section, control::Support support, Language l) {
    return fmt::format("{}: {} ({}){}\n", word, title.in(l), section,
                       support == control::Support::planned ? fmt::format(" [{}]", planned.in(l)) : "");
}

std::string headline(const diag::Row& row, Language l) {
    return fmt::format("{} {}: {}\n", row.code, diag::to_string(row.severity, l), without_values(row.message.in(l)));
}

std::string finding(diag::Id id, Language l) {
    const diag::Row& row = diag::row(id);
    std::string out = headline(row, l);
    if (!row.alarm_8055.empty()) out += fmt::format("8055: {}\n", row.alarm_8055);
    if (!row.alarm_8025.empty()) out += fmt::format("8025: {}\n", row.alarm_8025);
    if (const auto page = trimmed(diag::explain_page(id, l)); !page.empty()) out += fmt::format("\n{}\n", page);
    Text title = raises;
    for (const auto program : diag::explain_examples(id))
        out += fmt::format("\n{}\n{}", std::exchange(title, does_not).in(l), indented(trimmed(program)));
    return out;
}

std::string construct(const control::Construct& c, Language l) {
    return head(c.code, c.title, c.section, c.support, l) + indented(c.syntax) + operands(c.operands, l) +
           fmt::format("{}\n{}", example.in(l), indented(c.snippet));
}

std::string statement(const control::StatementRow& s, Language l) {
    return head(s.word, s.title, s.section, s.support, l) + indented(s.syntax) + operands(s.operands, l) +
           fmt::format("{}\n{}", example.in(l), indented(s.snippet));
}

std::string variable(const control::Variable& v, Language l) {
    std::string out =
        head(v.per_axis ? fmt::format("{}(X-C)", v.name) : std::string(v.name), v.title, v.section, v.support, l);
    out += fmt::format("  {}", control::describe(v.knowledge).in(l));
    if (!v.writable) out += fmt::format(", {}", read_only.in(l));
    if (v.stops_preparation) out += fmt::format(", {}", stops.in(l));
    return out + '\n';
}

/// The findings for which the control shows a number, one a line; the page where there is only one.
std::string alarm(const control::Dialect& d, std::string_view number, Language l) {
    if (number.size() > diag::alarm_digits || number.find_first_not_of("0123456789") != number.npos) return {};
    const auto found = diag::with_alarm(fmt::format("{:0>{}}", number, diag::alarm_digits), d.name);
    if (found.size() == 1) return finding(found.front(), l);
    std::string out;
    for (const diag::Id id : found) out += headline(diag::row(id), l);
    return out;
}

/// "G1", "G01" and "G 1" name one code.
const control::Construct* find_code(const control::Dialect& d, const std::string& word) {
    if (word.size() < 2 || word.find_first_not_of("0123456789", 1) != word.npos || word.size() > 5) return nullptr;
    return d.find(word[0], static_cast<std::uint16_t>(std::stoi(word.substr(1))));
}

const control::Variable* find_variable(const control::Dialect& d, std::string_view word) {
    for (const control::Variable& v : d.variables)
        if (word == v.name ||
            (v.per_axis && word.size() == v.name.size() + 1 && word.starts_with(v.name) && axis_of(word.back())))
            return &v;
    return nullptr;
}

std::string page(const control::Dialect& d, const std::string& word, Language l) {
    if (const auto id = diag::find(word)) return finding(*id, l);
    if (const auto* c = find_code(d, word)) return construct(*c, l);
    if (const auto* s = d.find_statement(word)) return statement(*s, l);
    for (const control::StatementRow& o : d.operators)
        if (o.word == word) return statement(o, l);
    for (const control::StatementRow& a : d.addresses)
        if (a.word == word) return statement(a, l);
    if (const auto* v = find_variable(d, word)) return variable(*v, l);
    return alarm(d, word, l);
}

Exit explain(const Options& o) {
    const control::Dialect* d =
        o.settings.control == "auto" ? frontend::dialects().front() : frontend::dialect(o.settings.control);
    const std::string text = page(*d, upper(o.word), language_of(o.settings));
    if (text.empty()) {
        std::fprintf(stderr, "fagorc: %s is no finding, alarm, code, statement, operator or variable of the %s\n",
                     o.word.c_str(), std::string(d->name).c_str());
        return Exit::could_not_run;
    }
    std::fwrite(text.data(), 1, text.size(), stdout);
    return Exit::ok;
}

}  // namespace

void add_explain(CLI::App& app, Exit& exit) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("explain", "Say what a finding, alarm, code, statement or variable means");
    command->add_option("WORD", options->word, "F0606, 0043, G68, RPT, POSX ...")->required();
    command->add_option("--control", options->settings.control, "control whose tables are read")
        ->check(CLI::IsMember({"auto", "8055"}));
    command->add_option("--lang", options->settings.language, "en, fr, es (default: the locale)")
        ->check(CLI::IsMember({"en", "fr", "es"}));
    command->footer(
        "Examples:\n"
        "  fagorc explain F0606\n"
        "  fagorc explain 0043\n"
        "  fagorc explain G33 --lang fr\n"
        "  fagorc explain POSX");
    command->callback([options, &exit] { exit = explain(*options); });
}

}  // namespace fagorc::tool
