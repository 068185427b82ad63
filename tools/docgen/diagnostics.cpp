#include "tools/docgen/diagnostics.hpp"

#include <fmt/format.h>

#include "ir/diag/catalogue.hpp"

namespace fagorc::docgen {
namespace {

constexpr std::string_view mark = "<!-- index: made by tools/docgen -->\n";

std::string alarms(const diag::Row& row) {
    std::string out(row.alarm_8055);
    if (!row.alarm_8025.empty()) out += fmt::format("{}8025: {}", out.empty() ? "" : "; ", row.alarm_8025);
    return out;
}

}  // namespace

std::string diagnostics(std::string_view page) {
    const std::size_t at = page.find(mark);
    if (at == page.npos) return {};
    std::string out(page.substr(0, at + mark.size()));
    out += "\n| code | name | severity | alarm of the 8055 | text |\n|---|---|---|---|---|\n";
    for (std::size_t i = 0; i < diag::row_count(); ++i) {
        const diag::Row& row = diag::row(static_cast<diag::Id>(i));
        out += fmt::format("| [{0}](../ir/diag/explain/{0}.md) | `{1}` | {2} | {3} | {4}<br>{5}<br>{6} |\n", row.code,
                           row.name, diag::to_string(row.severity, Language::english), alarms(row), row.message.en,
                           row.message.fr, row.message.es);
    }
    return out;
}

}  // namespace fagorc::docgen
