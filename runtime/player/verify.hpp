// Checks a whole trajectory file: every byte against its hash, every record against the others.
#pragma once

#include "runtime/player/trajectory.hpp"

namespace fagorc::player {

/// The first thing that is wrong with a file.
struct Finding {
    Status status = Status::ok;
    std::uint64_t block = 0;  ///< number of the block, from 0
    const char* what = "";    ///< in English, for `malformed`
};

/// What `ok` promises: every byte is as it was written, all numbers that records refer by exist, records are in order,
/// index and totals agree with the blocks, and nothing follows the end.
Finding verify(Bytes file);

}  // namespace fagorc::player
