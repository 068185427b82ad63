#include "ir/diag/catalogue.hpp"

#include <array>

namespace fagorc::diag {
namespace {

using enum Severity;

constexpr Row rows[] = {
#define DIAG(code, severity, name, alarm_8055, alarm_8025, en, fr, es) \
    Row{#code, #name, severity, alarm_8055, alarm_8025, Text{en, fr, es}},
#define RETIRED(code)
#include "ir/diag/diagnostics.def"
#undef DIAG
#undef RETIRED
};

}  // namespace

const Row& row(Id id) { return rows[static_cast<std::size_t>(id)]; }
std::size_t row_count() { return std::size(rows); }

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

}  // namespace fagorc::diag
