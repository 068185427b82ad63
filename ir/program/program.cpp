#include "ir/program/program.hpp"

#include <algorithm>

namespace fagorc::program {

std::string_view text_of(const Block& block, std::uint16_t slot) {
    const Quantity& q = block.slots[slot];
    std::string_view text = block.text.substr(q.at, q.length);
    if (text.size() >= 2 && text.front() == '"' && text.back() == '"') text = text.substr(1, text.size() - 2);
    return text;
}

diag::Place Program::place(const Block& block, std::uint32_t first, std::uint32_t end) {
    const auto all = tokens(block);
    if (first >= all.size()) return place(block);
    const auto& a = all[first];
    const auto& b = all[std::clamp<std::size_t>(end, first + 1, all.size()) - 1];
    return {file(), block.here.line, a.at + 1, b.at + b.length + 1, block.here.offset};
}

diag::Place Program::place(const Block& block) {
    return {file(), block.here.line, 1, static_cast<std::uint32_t>(block.text.size()) + 1, block.here.offset};
}

}  // namespace fagorc::program
