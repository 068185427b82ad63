#include "runtime/player/trajectory.hpp"

#include <algorithm>
#include <array>

#include "runtime/player/xxh3.hpp"

namespace fagorc::player {
namespace {

constexpr std::array<unsigned char, 8> magic = {0x89, 'F', 'T', 'J', '\r', '\n', 0x1a, '\n'};
constexpr std::uint16_t major_version = 1;
constexpr std::uint64_t end_size = block_header_size + 56;

struct IndexEntry {
    std::uint64_t offset, first;
    Type type;
    std::uint32_t number, flags;
};

IndexEntry read_entry(const Block& index, std::uint64_t i) {
    const std::byte* p = record(index, 0, i);
    return {load<std::uint64_t>(p), load<std::uint64_t>(p + 16), static_cast<Type>(load<std::uint32_t>(p + 8)),
            load<std::uint32_t>(p + 24), load<std::uint32_t>(p + 28)};
}

std::string_view characters(Bytes bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

}  // namespace

Status Trajectory::open(Bytes file) {
    *this = {};
    file_ = file;
    if (file.size() < magic.size() || std::memcmp(file.data(), magic.data(), magic.size()) != 0)
        return Status::not_a_trajectory;
    if (file.size() < file_header_size) return Status::truncated;
    if (load<std::uint32_t>(file.data() + 12) != static_cast<std::uint32_t>(xxh3_64(file.first(12))))
        return Status::damaged;
    if (load<std::uint16_t>(file.data() + 8) != major_version) return Status::newer_version;
    return open_indexed() == Status::ok ? Status::ok : walk();
}

/// Takes the totals of END and the place of INDEX. Not ok: the file has no whole end.
Status Trajectory::open_indexed() {
    if (file_.size() < file_header_size + end_size || file_.size() % 8 != 0) return Status::truncated;
    const auto end = block_at(file_, file_.size() - end_size);
    if (!end || end->type != Type::end || !well_formed(*end)) return Status::truncated;
    const std::byte* p = end->payload.data();
    const std::uint64_t blocks = load<std::uint64_t>(p + 8);
    if (blocks < 2 || !intact(file_, *end, blocks - 1)) return Status::damaged;
    const auto index = block_at(file_, load<std::uint64_t>(p));
    if (!index || index->type != Type::index || !well_formed(*index) || !intact(file_, *index, blocks - 2))
        return Status::damaged;
    for (std::uint64_t i = 0; i < index->count; ++i) {
        const IndexEntry e = read_entry(*index, i);
        if ((e.flags & 1) && !layout_of(e.type)) return Status::unknown_block;
    }
    index_ = index;
    end_ = file_.size();
    blocks_ = blocks;
    moves_ = load<std::uint64_t>(p + 16);
    events_ = load<std::uint64_t>(p + 24);
    states_ = load<std::uint32_t>(p + 32);
    chains_ = load<std::uint32_t>(p + 36);
    texts_ = load<std::uint32_t>(p + 40);
    programs_ = load<std::uint32_t>(p + 44);
    completed_ = load<std::uint32_t>(p + 48) & 1;
    return Status::ok;
}

Status Trajectory::walk() {
    end_ = file_header_size;
    while (true) {
        const auto block = block_at(file_, end_);
        if (!block) return Status::truncated;
        if (!intact(file_, *block, blocks_)) return Status::damaged;
        if (block->critical && !layout_of(block->type)) return Status::unknown_block;
        if (!well_formed(*block)) return Status::malformed;
        count(*block);
        end_ = block->next;
        ++blocks_;
    }
}

void Trajectory::count(const Block& b) {
    switch (b.type) {
        case Type::moves:
        case Type::wide:
            moves_ += b.count;
            break;
        case Type::events:
            events_ += b.count;
            break;
        case Type::states:
            states_ += b.count;
            break;
        case Type::chains:
            chains_ += b.count;
            break;
        case Type::texts:
            texts_ += b.count;
            break;
        case Type::source:
            programs_ = std::max(programs_, load<std::uint32_t>(b.payload.data() + 8) + 1);
            break;
        case Type::meta:
        case Type::tools:
        case Type::live:
        case Type::picture:
        case Type::index:
        case Type::end:
            break;
    }
}

std::optional<Block> Trajectory::block_in(std::uint64_t offset) const {
    return offset < end_ ? block_at(file_.first(end_), offset) : std::nullopt;
}

std::optional<Block> Trajectory::find(Type type, std::uint64_t n) const {
    return index_ ? find_by_index(type, n) : find_by_walking(type, n);
}

/// Entries stand by type, then in the order of the file.
std::optional<Block> Trajectory::find_by_index(Type type, std::uint64_t n) const {
    std::uint64_t low = 0, high = index_->count;  // the first entry after (type, n) lies in [low, high]
    while (low < high) {
        const std::uint64_t middle = (low + high) / 2;
        const IndexEntry e = read_entry(*index_, middle);
        if (e.type < type || (e.type == type && e.first <= n))
            low = middle + 1;
        else
            high = middle;
    }
    if (low == 0) return std::nullopt;
    const IndexEntry e = read_entry(*index_, low - 1);
    const auto block = block_in(e.offset);
    if (e.type != type || !block || block->type != type || !well_formed(*block)) return std::nullopt;
    return n >= block->first && n - block->first < block->count ? block : std::nullopt;
}

std::optional<Block> Trajectory::find_by_walking(Type type, std::uint64_t n) const {
    for (auto block = first_block(); block; block = next_block(*block))
        if (block->type == type && n >= block->first && n - block->first < block->count) return block;
    return std::nullopt;
}

std::optional<Block> Trajectory::find_move(std::uint64_t n) const {
    const auto plain = find(Type::moves, n);
    return plain ? plain : find(Type::wide, n);
}

const std::byte* Trajectory::find_record(Type type, std::uint64_t n) const {
    const auto block = find(type, n);
    return block ? record(*block, 0, n - block->first) : nullptr;
}

std::optional<State> Trajectory::state(std::uint32_t n) const {
    const std::byte* r = find_record(Type::states, n);
    return r ? std::optional(read_state(r)) : std::nullopt;
}

std::optional<Chain> Trajectory::chain(std::uint32_t n) const {
    const std::byte* r = find_record(Type::chains, n);
    return r ? std::optional(read_chain(r)) : std::nullopt;
}

std::optional<Event> Trajectory::event(std::uint64_t n) const {
    const std::byte* r = find_record(Type::events, n);
    return r ? std::optional(read_event(r)) : std::nullopt;
}

std::optional<Tool> Trajectory::tool(std::uint64_t n) const {
    const std::byte* r = find_record(Type::tools, n);
    return r ? std::optional(read_tool(r)) : std::nullopt;
}

std::uint64_t Trajectory::first_event_before(std::uint64_t move) const {
    std::uint64_t low = 0, high = events_;
    while (low < high) {
        const std::uint64_t middle = (low + high) / 2;
        const auto e = event(middle);
        if (e && e->before < move)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

std::string_view Trajectory::text(std::uint32_t n) const {
    const auto block = find(Type::texts, n);
    if (!block) return {};
    std::size_t at = 0;
    for (std::uint64_t i = block->first;; ++i) {
        const auto size = load<std::uint32_t>(block->payload.data() + at);
        at += sizeof size;
        if (i == n) return characters(block->payload.subspan(at, size));
        at += size;
    }
}

std::string_view Trajectory::meta() const {
    const auto block = find(Type::meta, 0);
    return block ? characters(block->payload) : std::string_view{};
}

std::optional<Block> Trajectory::find_source(std::uint32_t program, std::uint64_t at) const {
    const auto fits = [&](const std::optional<Block>& b) {
        return b && b->type == Type::source && well_formed(*b) &&
               load<std::uint32_t>(b->payload.data() + 8) == program && at >= b->first &&
               (at - b->first < b->count || (b->count == 0 && at == b->first));
    };
    if (!index_) {
        for (auto block = first_block(); block; block = next_block(*block))
            if (fits(block)) return block;
        return std::nullopt;
    }
    for (std::uint64_t i = 0; i < index_->count; ++i) {
        const IndexEntry e = read_entry(*index_, i);
        if (e.type != Type::source || e.first > at) continue;
        if (const auto block = block_in(e.offset); fits(block)) return block;
    }
    return std::nullopt;
}

std::optional<Program> Trajectory::program(std::uint32_t n) const {
    const auto block = find_source(n, 0);
    if (!block) return std::nullopt;
    const auto name = load<std::uint32_t>(block->payload.data() + 12);
    return Program{characters(block->payload.subspan(16, name)), load<std::uint64_t>(block->payload.data())};
}

std::string_view Trajectory::source(std::uint32_t program, std::uint64_t at) const {
    const auto block = find_source(program, at);
    if (!block) return {};
    const auto name = load<std::uint32_t>(block->payload.data() + 12);
    return characters(block->payload.subspan(16 + name)).substr(at - block->first);
}

}  // namespace fagorc::player
