#include "frontend/machine/findings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace fagorc::frontend::machine_file {

Findings::Findings(std::string_view text, diag::FileId file) : text_(text), file_(file), lines_{0} {
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] == '\n') lines_.push_back(i + 1);
}

/// TOML counts characters, places count bytes: the bytes that go on with a UTF-8 character are added.
std::uint32_t Findings::byte_column(std::string_view line, std::uint32_t column) const {
    std::uint32_t characters = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const bool goes_on = (static_cast<unsigned char>(line[i]) & 0xc0) == 0x80;
        if (!goes_on && ++characters == column) return static_cast<std::uint32_t>(i + 1);
    }
    return static_cast<std::uint32_t>(line.size() + 1);
}

diag::Place Findings::place(const Spot& spot) const {
    if (spot.line == 0 || spot.line > lines_.size()) return {file_, 1, 1, 1, 0};
    const std::size_t begin = lines_[spot.line - 1];
    std::size_t end = spot.line < lines_.size() ? lines_[spot.line] - 1 : text_.size();
    if (end > begin && text_[end - 1] == '\r') --end;
    const std::string_view line = text_.substr(begin, end - begin);
    diag::Place p{file_, spot.line, byte_column(line, spot.column), 0, begin};
    p.end_column =
        spot.end_line == spot.line ? byte_column(line, spot.end_column) : static_cast<std::uint32_t>(line.size() + 1);
    p.end_column = std::max(p.end_column, p.column + 1);
    return p;
}

void Findings::hand_on(diag::Sink& to) const {
    std::vector<diag::Diagnostic> sorted = collected_.list();
    std::stable_sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) {
        return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
    });
    for (diag::Diagnostic& d : sorted) to.report(std::move(d));
}

std::string range_text(const control::Range& range) {
    if (std::isinf(range.most)) return fmt::format("{} {}", range.above ? ">" : ">=", range.least);
    if (std::isinf(range.least)) return fmt::format("<= {}", range.most);
    return fmt::format("{} .. {}", range.least, range.most);
}

std::string choices_text(std::span<const std::string_view> choices) {
    return fmt::format("{}", fmt::join(choices, ", "));
}

}  // namespace fagorc::frontend::machine_file
