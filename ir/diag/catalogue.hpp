// The rows of diagnostics.def as data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ir/base/text.hpp"
#include "ir/diag/diagnostic.hpp"

namespace fagorc::diag {

enum class Severity : std::uint8_t { note, warning, error };

struct Row {
    std::string_view code;  ///< "F0201"
    std::string_view name;  ///< "not_yet_supported"
    Severity severity{};
    std::string_view alarm_8055;  ///< the control's own number as it shows it ("0046"), or empty; see `alarm`
    std::string_view alarm_8025;
    Text message;  ///< with {0}, {1} ... for the arguments
};

const Row& row(Id id);
std::size_t row_count();

/// The diagnostic of a code or a name, in any letter case: "F0201", "not_yet_supported".
std::optional<Id> find(std::string_view code_or_name);

/// The diagnostics for which a control ("8055") shows a number as it stands on its screen ("0043"), by their codes.
std::vector<Id> with_alarm(std::string_view number, std::string_view control);

/// The message of a diagnostic in a language, arguments put in.
std::string message(const Diagnostic& diagnostic, Language language);

/// The number that a control ("8055", "8025") shows for a diagnostic; empty where it has none. Where the row has a list
/// or a range of numbers the first argument chooses: an axis letter, or a number that counts from 1.
std::string alarm(const Diagnostic& diagnostic, std::string_view control);

/// "error", "warning", "note" in a language.
std::string_view to_string(Severity severity, Language language);

}  // namespace fagorc::diag
