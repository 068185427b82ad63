// The names of the diagnostics, one a row of diagnostics.def.
#pragma once

#include <cstdint>

namespace fagorc::diag {

enum class Id : std::uint16_t {
#define DIAG(code, severity, name, alarm_8055, alarm_8025, en, fr, es) name,
#define RETIRED(code)
#include "ir/diag/diagnostics.def"
#undef DIAG
#undef RETIRED
};

}  // namespace fagorc::diag
