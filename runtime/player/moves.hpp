// Moves of a trajectory one after the other, whatever their records are.
#pragma once

#include "runtime/player/trajectory.hpp"

namespace fagorc::player {

class MoveReader {
  public:
    /// Begins at move `first`; seeking reads at most one block.
    explicit MoveReader(const Trajectory& trajectory, std::uint64_t first = 0);

    /// The next move, valid until the next call; null after the last.
    const Move* next() {
        if (left_ == 0 && !enter(next_)) return nullptr;
        move_.start = move_.end;
        read_move(record_, wide_, move_);
        move_.number = next_++;
        record_ += stride_;
        --left_;
        return &move_;
    }

  private:
    /// Goes to the block of move `n`, to the record of it.
    bool enter(std::uint64_t n);

    const Trajectory& trajectory_;
    Move move_;
    std::uint64_t next_;
    const std::byte* record_ = nullptr;
    std::uint32_t left_ = 0;
    std::uint16_t stride_ = 0;
    bool wide_ = false;
};

}  // namespace fagorc::player
