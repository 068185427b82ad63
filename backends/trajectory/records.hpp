// Values of the program and its states as the numbers of the file format: pinned, whatever happens to the enumerators.
#pragma once

#include "backends/numbering.hpp"
#include "backends/trajectory/format.hpp"

namespace fagorc::backends::trajectory {

/// Event codes are the enumerators of operation::Event::Kind; a stop of block preparation has a code of its own.
inline constexpr std::uint8_t barrier_code = 255;

StateRecord state_record(const operation::Tables& tables, const Situation& situation);

}  // namespace fagorc::backends::trajectory
