#include "frontend/structure/index.hpp"

namespace fagorc::frontend {

void LabelTable::add(std::uint32_t label, std::uint32_t line) {
    const bool in_order = sorted_ == entries_.size() && (entries_.empty() || label > entries_.back().label);
    entries_.push_back({label, line});
    if (in_order) {
        ++sorted_;
        return;
    }
    // Merging only when the tail has grown by a share keeps both a million labels out of order and each search cheap.
    if (entries_.size() - sorted_ < 64 + sorted_ / 16) return;
    const auto before = [](const Entry& a, const Entry& b) { return a.label < b.label; };
    const auto tail = entries_.begin() + static_cast<std::ptrdiff_t>(sorted_);
    std::stable_sort(tail, entries_.end(), before);
    std::inplace_merge(entries_.begin(), tail, entries_.end(), before);
    sorted_ = entries_.size();
}

std::optional<std::uint32_t> LabelTable::find(std::uint32_t label) const {
    const auto tail = entries_.begin() + static_cast<std::ptrdiff_t>(sorted_);
    const auto at = std::lower_bound(entries_.begin(), tail, label,
                                     [](const Entry& e, std::uint32_t wanted) { return e.label < wanted; });
    if (at != tail && at->label == label) return at->line;
    const auto late = std::find_if(tail, entries_.end(), [label](const Entry& e) { return e.label == label; });
    return late != entries_.end() ? std::optional(late->line) : std::nullopt;
}

}  // namespace fagorc::frontend
