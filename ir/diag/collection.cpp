#include "ir/diag/collection.hpp"

#include <cassert>

namespace fagorc::diag {

std::size_t Once::Hash::operator()(const Key& key) const {
    std::uint64_t h = key.place.block;
    for (std::uint64_t part :
         {std::uint64_t{key.place.line}, std::uint64_t{key.place.column}, std::uint64_t{key.place.end_column},
          static_cast<std::uint64_t>(key.place.file), static_cast<std::uint64_t>(key.id)})
        h = (h ^ part) * 0x9e3779b97f4a7c15u ^ (h >> 29);
    return static_cast<std::size_t>(h);
}

bool Once::is_new(const Key& key) {
    if (seen_before_.contains(key) || !seen_.insert(key).second) return false;
    if (seen_.size() >= remembered) {
        seen_before_ = std::move(seen_);
        seen_.clear();
    }
    return true;
}

void Once::report(Diagnostic diagnostic) {
    assert(takes(diagnostic.id, diagnostic.arguments.size()));
    const bool full = limit_ != 0 && passed_ >= limit_;
    const Severity severity = row(diagnostic.id).severity;
    if (!full && diagnostic.place.file != FileId::none && !is_new({diagnostic.id, diagnostic.place})) return;
    ++counts_.by_severity[static_cast<std::size_t>(severity)];
    if (full) {
        ++left_out_;
        return;
    }
    ++passed_;
    next_.report(std::move(diagnostic));
}

}  // namespace fagorc::diag
