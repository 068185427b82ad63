#include "tools/fagorc/report/snippet.hpp"

#include <algorithm>
#include <vector>

#include "tools/fagorc/report/readable.hpp"

namespace fagorc::report {
namespace {

constexpr std::size_t tab_width = 4;
constexpr std::string_view ellipsis = "...";

/// Bytes of a line that are looked at before and after the piece: a line may be as long as a file.
constexpr std::size_t reach = 4096;

bool continues_character(char c) {
    return (static_cast<unsigned char>(c) & 0xC0) == 0x80;
}

/// A character at its column of the terminal, tabs already blanks.
struct Placed {
    std::string text;
    std::size_t at = 0;    ///< byte in the line
    std::size_t from = 0;  ///< first column
    std::size_t to = 0;    ///< column after it
};

std::vector<Placed> placed(std::string_view line, std::size_t first_byte) {
    std::vector<Placed> out;
    std::size_t column = 0;
    for (const Cell& cell : cells(line)) {
        const std::size_t width = cell.code == '\t' ? tab_width - column % tab_width : cell.width;
        out.push_back(
            {cell.code == '\t' ? std::string(width, ' ') : cell.text, first_byte + cell.at, column, column + width});
        column += width;
    }
    return out;
}

/// The column of a byte; the column after the line for a byte after its end.
std::size_t column_of(const std::vector<Placed>& characters, std::size_t byte) {
    const auto after = std::upper_bound(characters.begin(), characters.end(), byte,
                                        [](std::size_t b, const Placed& p) { return b < p.at; });
    if (after != characters.begin() && after != characters.end()) return (after - 1)->from;
    if (after == characters.begin()) return 0;
    const Placed& last = *(after - 1);
    return byte == last.at ? last.from : last.to;
}

}  // namespace

Snippet snippet(std::string_view line, std::uint32_t column, std::uint32_t end_column, std::size_t width) {
    const std::size_t begin = std::min<std::size_t>(column == 0 ? 0 : column - 1, line.size());
    const std::size_t end = std::clamp<std::size_t>(end_column == 0 ? 0 : end_column - 1, begin, line.size());
    std::size_t from = begin > reach ? begin - reach : 0;
    std::size_t to = std::min(line.size(), begin + reach);
    while (from > 0 && from < begin && continues_character(line[from])) ++from;
    while (to < line.size() && to > begin && continues_character(line[to])) --to;
    const std::vector<Placed> characters = placed(line.substr(from, to - from), from);

    const std::size_t first = column_of(characters, begin);
    const std::size_t last = std::max(first + 1, column_of(characters, end));
    const std::size_t total = std::max(characters.empty() ? 0 : characters.back().to, first + 1);

    // The window of columns that is shown: a third of the width before the piece, moved to the line's end if it fits.
    const std::size_t room = std::max(width, 4 * ellipsis.size());
    std::size_t left = 0, right = total;
    if (total > room) {
        left = first > room / 3 ? first - room / 3 : 0;
        left = std::min(left, total - room);
        right = left + room;
    }
    const bool cut_left = left > 0 || from > 0, cut_right = right < total || to < line.size();
    if (cut_left) left += ellipsis.size();
    if (cut_right && right > left + ellipsis.size()) right -= ellipsis.size();

    Snippet out;
    if (cut_left) out.text = ellipsis;
    std::size_t shown = left;
    for (const Placed& c : characters) {
        if (c.from < left || c.to > right) continue;
        out.text.append(c.from - shown, ' ');  // a tab or a wide character that the cut has halved
        out.text += c.text;
        shown = c.to;
    }
    if (cut_right) out.text += ellipsis;
    const std::size_t caret = std::max(first, left);
    out.indent.assign(caret - left + (cut_left ? ellipsis.size() : 0), ' ');
    out.carets = std::max<std::size_t>(1, std::min(last, right) - std::min(caret, right));
    return out;
}

}  // namespace fagorc::report
