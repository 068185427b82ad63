#include "frontend/structure/index.hpp"

#include <algorithm>

namespace fagorc::frontend {

std::optional<std::uint32_t> LabelTable::find(std::uint32_t label) {
    const auto before = [](const Entry& a, const Entry& b) { return a.label < b.label; };
    if (!sorted_) {
        // Stable: of equal labels the first block of the text stays first, and that one counts (8055 T 2.3).
        std::stable_sort(entries_.begin(), entries_.end(), before);
        sorted_ = true;
    }
    const auto at = std::lower_bound(entries_.begin(), entries_.end(), Entry{label, 0}, before);
    return at != entries_.end() && at->label == label ? std::optional(at->line) : std::nullopt;
}

}  // namespace fagorc::frontend
