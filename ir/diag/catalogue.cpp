#include "ir/diag/catalogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <iterator>
#include <utility>

#include "ir/base/axis.hpp"
#include "ir/diag/alarm.hpp"

namespace fagorc::diag {
namespace {

using enum Severity;

/// The arguments that a text takes, as a bit mask; -1 for a brace that is no placeholder.
consteval int placeholders(std::string_view text) {
    int mask = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '}') return -1;
        if (text[i] != '{') continue;
        if (i + 2 >= text.size() || text[i + 1] < '0' || text[i + 1] > '9' || text[i + 2] != '}') return -1;
        mask |= 1 << (text[i + 1] - '0');
        i += 2;
    }
    return mask;
}

/// A translation that lost an argument, a missing text or a malformed alarm does not compile.
consteval bool well_formed(const Row& r) {
    const int arguments = placeholders(r.message.en);
    return r.message.complete() && arguments >= 0 && (arguments & (arguments + 1)) == 0 &&
           placeholders(r.message.fr) == arguments && placeholders(r.message.es) == arguments &&
           is_alarm_column(r.alarm_8055) && is_alarm_column(r.alarm_8025);
}

constexpr Row rows[] = {
#define DIAG(code, severity, name, alarm_8055, alarm_8025, en, fr, es) \
    Row{#code, #name, severity, alarm_8055, alarm_8025, Text{en, fr, es}},
#define RETIRED(code)
#include "ir/diag/diagnostics.def"
#undef DIAG
#undef RETIRED
};

// One check a row, so that the compiler names the row that is wrong.
#define DIAG(code, severity, name, alarm_8055, alarm_8025, en, fr, es)                            \
    static_assert(well_formed(Row{#code, #name, severity, alarm_8055, alarm_8025, {en, fr, es}}), \
                  #code " " #name ": texts, placeholders {0} {1} ... or alarm");
#define RETIRED(code)
#include "ir/diag/diagnostics.def"
#undef DIAG
#undef RETIRED

/// All codes that were ever given, in the order of the file.
constexpr std::string_view codes[] = {
#define DIAG(code, severity, name, alarm_8055, alarm_8025, en, fr, es) #code,
#define RETIRED(code) #code,
#include "ir/diag/diagnostics.def"
#undef DIAG
#undef RETIRED
};

consteval bool sorted_and_unique() {
    for (std::size_t i = 0; i < std::size(codes); ++i) {
        if (codes[i].size() != 5 || codes[i][0] != 'F') return false;
        if (i > 0 && codes[i - 1] >= codes[i]) return false;
    }
    return true;
}
static_assert(sorted_and_unique(), "diagnostics.def: codes are F and four digits, each once, in ascending order");

std::string_view column(const Row& r, std::string_view control) {
    static constexpr std::pair<std::string_view, std::string_view Row::*> columns[] = {{"8055", &Row::alarm_8055},
                                                                                       {"8025", &Row::alarm_8025}};
    for (const auto& [name, member] : columns)
        if (name == control) return r.*member;
    return {};
}

/// Position, from 0, in a list of alarms that an argument chooses; nothing where it chooses none.
std::optional<std::size_t> choice(const Diagnostic& d) {
    if (d.arguments.empty()) return std::nullopt;
    const std::string& first = d.arguments.front().plain;
    if (first.size() == 1)
        if (const auto axis = axis_of(first[0])) return index(*axis);
    std::size_t number = 0;
    const auto [end, error] = std::from_chars(first.data(), first.data() + first.size(), number);
    if (error != std::errc{} || end != first.data() + first.size() || number == 0) return std::nullopt;
    return number - 1;
}

bool same_letters(std::string_view a, std::string_view b) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; };
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [&](char x, char y) { return lower(x) == lower(y); });
}

}  // namespace

const Row& row(Id id) {
    return rows[static_cast<std::size_t>(id)];
}
std::size_t row_count() {
    return std::size(rows);
}

std::optional<Id> find(std::string_view code_or_name) {
    for (std::size_t i = 0; i < std::size(rows); ++i)
        if (same_letters(rows[i].code, code_or_name) || same_letters(rows[i].name, code_or_name))
            return static_cast<Id>(i);
    return std::nullopt;
}

std::vector<Id> with_alarm(std::string_view number, std::string_view control) {
    std::vector<Id> found;
    for (std::size_t i = 0; i < std::size(rows); ++i)
        if (holds_alarm(column(rows[i], control), number)) found.push_back(static_cast<Id>(i));
    return found;
}

bool takes(Id id, std::size_t count) {
    const std::string_view text = row(id).message.en;
    std::size_t places = 0;
    for (std::size_t at = text.find('{'); at != text.npos; at = text.find('{', at + 1))
        places = std::max(places, static_cast<std::size_t>(text[at + 1] - '0') + 1);
    return count == places;
}

std::string message(const Diagnostic& diagnostic, Language language) {
    std::string out;
    const std::string_view text = row(diagnostic.id).message.in(language);
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '{' && i + 2 < text.size() && text[i + 2] == '}') {
            const std::size_t n = static_cast<std::size_t>(text[i + 1] - '0');
            if (n < diagnostic.arguments.size()) out += diagnostic.arguments[n].in(language);
            i += 2;
        } else {
            out += text[i];
        }
    }
    return out;
}

std::string alarm(const Diagnostic& diagnostic, std::string_view control) {
    std::string_view all = column(row(diagnostic.id), control);
    const std::size_t mark = all.find_first_of("-,");
    if (mark == all.npos) return std::string(all);
    const auto chosen = choice(diagnostic);
    if (!chosen) return {};
    if (all[mark] == '-') {
        unsigned first = 0, last = 0;
        std::from_chars(all.data(), all.data() + mark, first);
        std::from_chars(all.data() + mark + 1, all.data() + all.size(), last);
        if (*chosen > last - first) return {};
        return fmt::format("{:0{}}", first + *chosen, mark);
    }
    for (std::size_t i = 0; i < *chosen; ++i) {
        const std::size_t comma = all.find(',');
        if (comma == all.npos) return {};
        all.remove_prefix(comma + 1);
    }
    return std::string(all.substr(0, all.find(',')));
}

std::string_view to_string(Severity severity, Language language) {
    static constexpr Text names[] = {
        {"note", "note", "nota"}, {"warning", "avertissement", "advertencia"}, {"error", "erreur", "error"}};
    return names[static_cast<std::size_t>(severity)].in(language);
}

}  // namespace fagorc::diag
