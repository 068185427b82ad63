// Parse each shape once: templates by the key of their shape.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/bind/bind.hpp"

namespace fagorc::frontend {

class ShapeCache {
  public:
    /// `keep` false: every call makes a template (the proof that shapes have one meaning). Templates that would take
    /// the cache beyond `limit` bytes are not kept either, so a program whose blocks all differ stays bounded.
    ShapeCache(TemplateMaker& maker, bool keep, std::size_t limit = default_limit);

    /// The template of a key. A kept one lives as long as the cache; one that is not kept is put into `own`.
    const program::BlockTemplate& find(std::string_view key, program::BlockTemplate& own);

    std::uint64_t shapes() const { return shapes_; }

    static constexpr std::size_t default_limit = std::size_t{16} << 20;

  private:
    struct Entry {
        std::uint64_t hash = 0;
        std::string key;
        std::unique_ptr<program::BlockTemplate> shape;
    };
    const program::BlockTemplate& make(std::string_view key, std::uint64_t hash, program::BlockTemplate& own);
    void grow();

    TemplateMaker& maker_;
    bool keep_;
    std::size_t limit_, bytes_ = 0, count_ = 0;
    std::uint64_t shapes_ = 0;
    std::vector<Entry> entries_;  ///< open addressing; a power of two
    const Entry* last_ = nullptr;
};

}  // namespace fagorc::frontend
