// Blocks of a trajectory file: filled record by record, numbered, hashed, written, remembered for the index.
#pragma once

#include <cstring>
#include <memory>
#include <type_traits>
#include <vector>

#include "backends/output.hpp"
#include "backends/trajectory/format.hpp"

namespace fagorc::backends::trajectory {

/// A block being filled: its header, a prefix of fixed size, then records or bytes. Of fixed capacity.
class Block {
  public:
    /// Bytes after the header.
    static constexpr std::size_t capacity = block_size - sizeof(BlockHeader);

    /// `record_size` 0: the records differ in length.
    Block(std::uint32_t type, std::uint16_t flags, std::size_t record_size, std::size_t prefix = 0);

    bool empty() const { return end_ == start(); }
    bool has_room(std::size_t size) const { return block_size - end_ >= size; }

    /// The next record, to be filled in place; the block must have room for it.
    template <class Record>
    Record& add() {
        static_assert(std::is_trivially_copyable_v<Record> && alignof(Record) <= 8);
        auto* record = ::new (bytes_.get() + end_) Record;
        end_ += sizeof(Record);
        return *record;
    }
    void append(const void* data, std::size_t size) {
        std::memcpy(bytes_.get() + end_, data, size);
        end_ += size;
    }
    std::byte* prefix() { return bytes_.get() + sizeof(BlockHeader); }
    /// Records of fixed size so far.
    std::uint32_t records() const { return static_cast<std::uint32_t>((end_ - start()) / record_size_); }

  private:
    friend class BlockWriter;
    std::size_t start() const { return sizeof(BlockHeader) + prefix_; }

    std::uint32_t type_;
    std::uint16_t flags_, record_size_;
    std::size_t prefix_, end_;
    std::unique_ptr<std::byte[]> bytes_;
};

/// Writes blocks one after the other and, at the end, their index.
class BlockWriter {
  public:
    explicit BlockWriter(Output& output);

    /// Writes a block and empties it. `first` is the number of its first record, `count` how many it has.
    void write(Block& block, std::uint64_t first, std::uint32_t count);
    /// Writes INDEX and END; `end` holds the totals, its places are filled in here.
    void finish(EndPayload end);

  private:
    void write(BlockHeader header, std::byte* bytes);

    Output& output_;
    std::vector<IndexRecord> index_;
    std::uint64_t offset_ = 0;
    std::uint32_t number_ = 0;
};

}  // namespace fagorc::backends::trajectory
