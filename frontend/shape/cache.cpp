#include "frontend/shape/cache.hpp"

#include <cstring>

namespace fagorc::frontend {
namespace {

std::uint64_t word_at(const char* p, std::size_t bytes) {
    std::uint64_t word = 0;
    std::memcpy(&word, p, bytes);
    return word;
}
std::uint64_t mixed(std::uint64_t hash, std::uint64_t word) {
    hash = (hash ^ word) * 0xff51afd7ed558ccdULL;
    return hash ^ hash >> 32;
}

/// Multiply and fold, eight bytes at a time; keys are 5 to 20 bytes. The last eight may overlap those before.
std::uint64_t hash_of(std::string_view key) {
    const std::size_t n = key.size();
    std::uint64_t h = n * 0x9e3779b97f4a7c15ULL;
    if (n < 8) return mixed(h, word_at(key.data(), n));
    for (std::size_t i = 0; i + 8 < n; i += 8) h = mixed(h, word_at(key.data() + i, 8));
    return mixed(h, word_at(key.data() + n - 8, 8));
}

}  // namespace

ShapeCache::ShapeCache(TemplateMaker& maker, bool keep, std::size_t limit)
    : maker_(maker), keep_(keep), limit_(limit), entries_(256) {}

const program::BlockTemplate& ShapeCache::find(std::string_view key, program::BlockTemplate& own) {
    // Neighbouring blocks mostly have one shape.
    if (last_ && last_->key == key) return *last_->shape;
    const std::uint64_t hash = hash_of(key);
    const std::size_t mask = entries_.size() - 1;
    for (std::size_t i = hash & mask; entries_[i].shape; i = (i + 1) & mask)
        if (entries_[i].hash == hash && entries_[i].key == key) {
            last_ = &entries_[i];
            return *last_->shape;
        }
    return make(key, hash, own);
}

const program::BlockTemplate& ShapeCache::make(std::string_view key, std::uint64_t hash, program::BlockTemplate& own) {
    ++shapes_;
    program::BlockTemplate made = maker_.make(key);
    const std::size_t bytes = made.bytes + sizeof(Entry) + key.size();
    if (!keep_ || bytes_ + bytes > limit_) return own = std::move(made);
    if (2 * ++count_ > entries_.size()) grow();
    bytes_ += bytes;
    const std::size_t mask = entries_.size() - 1;
    std::size_t i = hash & mask;
    while (entries_[i].shape) i = (i + 1) & mask;
    entries_[i] = {hash, std::string(key), std::make_unique<program::BlockTemplate>(std::move(made))};
    last_ = &entries_[i];
    return *last_->shape;
}

void ShapeCache::grow() {
    std::vector<Entry> old(entries_.size() * 2);
    old.swap(entries_);
    last_ = nullptr;
    const std::size_t mask = entries_.size() - 1;
    for (Entry& e : old) {
        if (!e.shape) continue;
        std::size_t i = e.hash & mask;
        while (entries_[i].shape) i = (i + 1) & mask;
        entries_[i] = std::move(e);
    }
}

}  // namespace fagorc::frontend
