#include "runtime/player/moves.hpp"

namespace fagorc::player {

MoveReader::MoveReader(const Trajectory& trajectory, std::uint64_t first) : trajectory_(trajectory), next_(first) {}

bool MoveReader::enter(std::uint64_t n) {
    const auto block = trajectory_.find_move(n);
    if (!block || !well_formed(*block)) return false;
    wide_ = block->type == Type::wide;
    stride_ = block->record_size;
    left_ = block->count;
    // A block says where the tool stands before its first move: the moves before `n` are read from there.
    move_.end = read_position(block->payload.data());
    record_ = record(*block, sizeof(Position), 0);
    for (std::uint64_t i = block->first; i < n; ++i) {
        read_move(record_, wide_, move_);
        record_ += stride_;
        --left_;
    }
    return true;
}

}  // namespace fagorc::player
