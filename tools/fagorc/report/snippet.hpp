// A line of a program with carets under a piece of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace fagorc::report {

/// The two rows of a snippet; the carets stand under the piece, whatever tabs and wide characters stand before it.
struct Snippet {
    std::string text;        ///< printable UTF-8, tabs expanded, cut around the piece to fit the width
    std::string indent;      ///< blanks before the carets
    std::size_t carets = 1;  ///< how many
};

/// `column` and `end_column` are bytes from 1, the end exclusive, as in diag::Place; an empty piece gets one caret.
Snippet snippet(std::string_view line, std::uint32_t column, std::uint32_t end_column, std::size_t width);

}  // namespace fagorc::report
