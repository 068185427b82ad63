// The rows of diagnostics.def as data.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "ir/base/text.hpp"
#include "ir/diag/diagnostic.hpp"

namespace fagorc::diag {

enum class Severity : std::uint8_t { note, warning, error };

struct Row {
    std::string_view code;             ///< "F0201"
    std::string_view name;             ///< "not_yet_supported"
    Severity severity{};
    std::string_view alarm_8055;       ///< the control's own number as it shows it ("0046"), or empty
    std::string_view alarm_8025;
    Text message;                      ///< with {0}, {1} ... for the arguments
};

const Row& row(Id id);
std::size_t row_count();

/// The message of a diagnostic in a language, arguments put in.
std::string message(const Diagnostic& diagnostic, Language language);

}  // namespace fagorc::diag
