// Blocks of a trajectory file, read in place (docs/trajectory-format.md). No allocation, no exception, and no byte is
// trusted: whatever the file holds, only its own bytes are read.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <span>

namespace fagorc::player {

using Bytes = std::span<const std::byte>;

/// A number of the file; `p` need not be aligned.
template <class T>
T load(const std::byte* p) {
    T value;
    std::memcpy(&value, p, sizeof value);
    return value;
}

constexpr std::uint32_t four(const char (&s)[5]) {
    std::uint32_t v = 0;
    for (int i = 3; i >= 0; --i) v = v << 8 | static_cast<unsigned char>(s[i]);
    return v;
}

/// Types of blocks, as the four letters that stand in the file. LIVE and PICT are reserved.
enum class Type : std::uint32_t {
    meta = four("META"),
    source = four("SRCE"),
    texts = four("STRS"),
    chains = four("CALL"),
    tools = four("TOOL"),
    states = four("STAT"),
    events = four("EVNT"),
    moves = four("MOVE"),
    wide = four("WIDE"),
    live = four("LIVE"),
    picture = four("PICT"),
    index = four("INDX"),
    end = four("END ")
};

/// What is wrong with a file.
enum class Status : std::uint8_t {
    ok,
    not_a_trajectory,  ///< the first bytes are others
    newer_version,     ///< the major version is not ours
    truncated,         ///< it ends early: what comes before can be read
    damaged,           ///< a hash does not fit
    unknown_block,     ///< a block of unknown type may not be left out
    malformed          ///< the bytes are as they were written, and wrong
};

inline constexpr std::size_t file_header_size = 16, block_header_size = 32;

/// One block. `payload` is without header and padding.
struct Block {
    Type type{};
    bool critical = false;
    std::uint16_t flags = 0, record_size = 0;
    std::uint32_t count = 0;
    std::uint64_t first = 0;             ///< number of its first record among all of its kind
    std::uint64_t offset = 0, next = 0;  ///< of the block and of the one after it, in the file
    std::uint64_t hash = 0;
    Bytes payload;
};

/// The block at an offset; nothing where its bytes do not lie in the file.
std::optional<Block> block_at(Bytes file, std::uint64_t offset);

/// Whether the hash of a block fits, as block `number` of the file.
bool intact(Bytes file, const Block& block, std::uint64_t number);

/// The layout that a known type asks for: the least record size, and the bytes before the records.
struct Layout {
    std::uint16_t record_size;
    std::uint16_t prefix;
    bool critical;
};
/// Nothing for an unknown or reserved type.
std::optional<Layout> layout_of(Type type);

/// Whether the counts of a block agree with its size; true for unknown types.
bool well_formed(const Block& block);

/// Record `i` of a well-formed block of fixed records.
inline const std::byte* record(const Block& block, std::size_t prefix, std::uint64_t i) {
    return block.payload.data() + prefix + i * block.record_size;
}

}  // namespace fagorc::player
