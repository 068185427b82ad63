// The scanner: the bytes of one block become the key of its shape and its quantities. It yields tokens and values and
// judges nothing: which order of tokens is a block, the grammar alone says.
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>
#include <vector>

#include "frontend/scan/lexicon.hpp"
#include "ir/program/token.hpp"

namespace fagorc::frontend {

/// Room for one block, used again for each.
class Scan {
  public:
    explicit Scan(std::size_t block_bytes);
    std::string_view key() const { return {key_begin_, key_size_}; }
    const program::Quantity* slots() const { return slots_.get(); }
    std::size_t slot_count() const { return slot_count_; }

  private:
    friend class Scanner;
    struct Release {
        std::size_t count = 0;
        void operator()(program::Quantity* slots) const;
    };
    std::unique_ptr<char[]> key_;
    std::unique_ptr<program::Quantity[], Release> slots_;
    const char* key_begin_ = nullptr;
    std::size_t key_size_ = 0, slot_count_ = 0;
};

class Scanner {
  public:
    explicit Scanner(const control::Dialect& dialect);

    /// How far a block reaches.
    struct Extent {
        std::size_t length = 0;  ///< bytes of the block without its line end
        std::size_t next = 0;    ///< offset of the next block: behind CR, LF or CR LF
        bool too_long = false;   ///< longer than the dialect's limit: the shape is worth nothing
    };
    /// Scans the block at `text`; a CR or LF must follow before the memory ends.
    Extent scan(const char* text, Scan& out) const;
    /// The tokens of a block with their places, by their index in the key (the mark of lower-case letters is none);
    /// the same scan, with a second listener. Empty for a block that is too long.
    std::vector<program::PlacedToken> tokens(const char* text, Scan& room) const;

  private:
    template <bool Placed>
    Extent run(const char* text, Scan& out, std::vector<program::PlacedToken>* placed) const;

    Lexicon lexicon_;
    std::size_t block_bytes_;
};

}  // namespace fagorc::frontend
