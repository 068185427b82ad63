#include "backends/trajectory/blocks.hpp"

#include <xxhash.h>

#include <algorithm>

namespace fagorc::backends::trajectory {
namespace {

constexpr std::size_t padded(std::size_t size) {
    return (size + 7) / 8 * 8;
}

}  // namespace

Block::Block(std::uint32_t type, std::uint16_t flags, std::size_t record_size, std::size_t prefix)
    : type_(type),
      flags_(flags),
      record_size_(static_cast<std::uint16_t>(record_size)),
      prefix_(prefix),
      end_(start()),
      bytes_(new std::byte[block_size]) {}  // not cleared: what is not filled is not touched

BlockWriter::BlockWriter(Output& output) : output_(output) {
    FileHeader header{magic, major_version, minor_version, 0};
    header.check = static_cast<std::uint32_t>(XXH3_64bits(&header, offsetof(FileHeader, check)));
    output_.write(std::as_bytes(std::span(&header, 1)));
    offset_ = sizeof header;
}

void BlockWriter::write(Block& block, std::uint64_t first, std::uint32_t count) {
    BlockHeader header{block.type_, block.flags_, block.record_size_, count, 0, first, 0};
    header.payload = static_cast<std::uint32_t>(block.end_ - sizeof header);
    index_.push_back({offset_, header.type, count, first, number_, header.flags});
    write(header, block.bytes_.get());
    block.end_ = block.start();
}

void BlockWriter::write(BlockHeader header, std::byte* bytes) {
    const std::size_t used = sizeof header + header.payload, size = padded(used);
    std::fill(bytes + used, bytes + size, std::byte{0});
    std::memcpy(bytes, &header, sizeof header);
    // Over the block with the hash field zero; the block's number is the seed, so that a block moved or left out shows.
    header.hash = XXH3_64bits_withSeed(bytes, size, number_);
    std::memcpy(bytes, &header, sizeof header);
    output_.write(Bytes(bytes, size));
    offset_ += size;
    ++number_;
}

void BlockWriter::finish(EndPayload end) {
    // By type, then in the order of the file: a reader finds a record of a type by bisection.
    std::stable_sort(index_.begin(), index_.end(),
                     [](const IndexRecord& a, const IndexRecord& b) { return a.type < b.type; });
    end.index_offset = offset_;
    end.blocks = number_ + 2;

    std::vector<std::byte> bytes(sizeof(BlockHeader) + index_.size() * sizeof(IndexRecord));
    BlockHeader header{type::index, 0, sizeof(IndexRecord), static_cast<std::uint32_t>(index_.size()), 0, 0, 0};
    header.payload = static_cast<std::uint32_t>(bytes.size() - sizeof header);
    std::memcpy(bytes.data() + sizeof header, index_.data(), header.payload);
    write(header, bytes.data());

    bytes.resize(sizeof(BlockHeader) + sizeof end);
    std::memcpy(bytes.data() + sizeof header, &end, sizeof end);
    write({type::end, critical, sizeof end, 1, sizeof end, 0, 0}, bytes.data());
}

}  // namespace fagorc::backends::trajectory
