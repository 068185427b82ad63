// Bytes of part programs as UTF-8 that a terminal and a JSON reader take: programs come in ASCII, UTF-8, Latin-1 (the
// control's own) and CP850 (PC editors of its time), and may hold control characters.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fagorc::report {

/// One character as it is shown.
struct Cell {
    std::string text;       ///< UTF-8, printable
    std::size_t width = 1;  ///< columns of a terminal: 0 for combining marks, 2 for wide characters
    std::size_t at = 0;     ///< offset of its first byte in the line
    char32_t code = 0;      ///< what was read
};

/// The characters of a text. A text that is no UTF-8 is taken as CP850 if it has bytes that are no characters in
/// Latin-1 (0x80 to 0x9F), else as Latin-1. Control characters are shown by their symbols; tabs stay tabs.
std::vector<Cell> cells(std::string_view bytes);

/// The same as one string of valid UTF-8.
std::string readable(std::string_view bytes);

/// Offset in code points of a byte offset.
std::size_t code_points_before(std::string_view bytes, std::size_t offset);

}  // namespace fagorc::report
