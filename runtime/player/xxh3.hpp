// XXH3-64, the hash of the blocks of a trajectory file, in plain C++: the player depends on nothing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace fagorc::player {

/// XXH3-64 of any number of bytes with a seed, as libxxhash's XXH3_64bits_withSeed computes it.
std::uint64_t xxh3_64(std::span<const std::byte> bytes, std::uint64_t seed = 0);

/// The same of `head`, at most 64 bytes, followed by `rest`.
std::uint64_t xxh3_64(std::span<const std::byte> head, std::span<const std::byte> rest, std::uint64_t seed);

}  // namespace fagorc::player
