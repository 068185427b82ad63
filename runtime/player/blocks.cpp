#include "runtime/player/blocks.hpp"

#include <algorithm>
#include <array>
#include <bit>

#include "runtime/player/xxh3.hpp"

namespace fagorc::player {

static_assert(std::endian::native == std::endian::little, "numbers are read as they lie in the file");

std::optional<Block> block_at(Bytes file, std::uint64_t offset) {
    if (offset > file.size() || file.size() - offset < block_header_size || offset % 8 != 0) return std::nullopt;
    const std::byte* p = file.data() + offset;
    const std::uint64_t payload = load<std::uint32_t>(p + 12), padded = (payload + 7) / 8 * 8;
    if (file.size() - offset - block_header_size < padded) return std::nullopt;
    Block b;
    b.type = static_cast<Type>(load<std::uint32_t>(p));
    b.flags = load<std::uint16_t>(p + 4);
    b.critical = b.flags & 1;
    b.record_size = load<std::uint16_t>(p + 6);
    b.count = load<std::uint32_t>(p + 8);
    b.first = load<std::uint64_t>(p + 16);
    b.hash = load<std::uint64_t>(p + 24);
    b.offset = offset;
    b.next = offset + block_header_size + padded;
    b.payload = file.subspan(offset + block_header_size, payload);
    return b;
}

bool intact(Bytes file, const Block& block, std::uint64_t number) {
    constexpr std::size_t hash_field = 24;
    std::array<std::byte, block_header_size> header;
    std::memcpy(header.data(), file.data() + block.offset, hash_field);
    std::fill(header.begin() + hash_field, header.end(), std::byte{0});
    const std::uint64_t body = block.offset + block_header_size;
    return xxh3_64(header, file.subspan(body, block.next - body), number) == block.hash;
}

namespace {

/// Texts have a length each: they must add up.
bool texts_fit(const Block& b) {
    std::uint64_t at = 0;
    for (std::uint32_t i = 0; i < b.count; ++i) {
        if (b.payload.size() - at < sizeof(std::uint32_t)) return false;
        const std::uint64_t size = load<std::uint32_t>(b.payload.data() + at);
        at += sizeof(std::uint32_t);
        if (b.payload.size() - at < size) return false;
        at += size;
    }
    return at == b.payload.size();
}

}  // namespace

std::optional<Layout> layout_of(Type type) {
    switch (type) {
        case Type::meta:
            return Layout{1, 0, false};
        case Type::source:
            return Layout{1, 16, false};
        case Type::texts:
            return Layout{0, 0, true};
        case Type::chains:
            return Layout{16, 0, true};
        case Type::tools:
            return Layout{80, 0, false};
        case Type::states:
            return Layout{160, 0, true};
        case Type::events:
            return Layout{40, 0, true};
        case Type::moves:
            return Layout{56, 72, true};
        case Type::wide:
            return Layout{120, 72, true};
        case Type::index:
            return Layout{32, 0, false};
        case Type::end:
            return Layout{56, 0, true};
        case Type::live:
        case Type::picture:
            break;
    }
    return std::nullopt;
}

bool well_formed(const Block& b) {
    const std::optional<Layout> layout = layout_of(b.type);
    if (!layout) return true;
    if (b.critical != layout->critical || b.payload.size() < layout->prefix) return false;
    std::uint64_t room = b.payload.size() - layout->prefix;
    if (b.type == Type::source) {
        const std::uint64_t name = load<std::uint32_t>(b.payload.data() + 12);
        if (name > room) return false;
        room -= name;
    }
    if (b.type == Type::texts) return texts_fit(b);
    // A later minor version may have longer records: what follows the known fields is left out.
    return b.record_size >= layout->record_size && std::uint64_t{b.count} * b.record_size == room &&
           (layout->record_size % 8 != 0 || b.record_size % 8 == 0);
}

}  // namespace fagorc::player
