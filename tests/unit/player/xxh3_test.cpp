// Our plain XXH3-64 against the reference implementation, for all sizes around its internal limits.
#include "runtime/player/xxh3.hpp"

#include <gtest/gtest.h>
#include <xxhash.h>

#include <vector>

namespace fagorc::player {
namespace {

std::vector<std::byte> bytes_of_size(std::size_t size) {
    std::vector<std::byte> bytes(size);
    std::uint32_t x = 12345;
    for (std::byte& b : bytes) b = static_cast<std::byte>((x = x * 1664525 + 1013904223) >> 24);
    return bytes;
}

TEST(Xxh3, EqualsTheReferenceForAllSmallSizesAndSeeds) {
    for (std::size_t size = 0; size <= 2200; ++size) {
        const auto bytes = bytes_of_size(size);
        for (std::uint64_t seed : {0ull, 1ull, 870ull, 0x9E3779B185EBCA87ull})
            ASSERT_EQ(xxh3_64(bytes, seed), XXH3_64bits_withSeed(bytes.data(), size, seed)) << size << ' ' << seed;
    }
}

TEST(Xxh3, EqualsTheReferenceForBlocks) {
    for (std::size_t size : {65512u, 65536u, 1u << 20}) {
        const auto bytes = bytes_of_size(size);
        ASSERT_EQ(xxh3_64(bytes, 7), XXH3_64bits_withSeed(bytes.data(), size, 7)) << size;
    }
}

TEST(Xxh3, TwoPiecesHashAsOne) {
    for (std::size_t size = 64; size <= 1500; ++size) {
        const auto bytes = bytes_of_size(size);
        const std::span all(bytes);
        for (std::size_t head : {0u, 32u, 64u})
            ASSERT_EQ(xxh3_64(all.first(head), all.subspan(head), 3), xxh3_64(all, 3)) << size << ' ' << head;
    }
}

}  // namespace
}  // namespace fagorc::player
