// After the specification of XXH3 (github.com/Cyan4973/xxHash, doc/xxhash_spec.md); the constants are the algorithm's.
#include "runtime/player/xxh3.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

namespace fagorc::player {
namespace {

using u32 = std::uint32_t;
using u64 = std::uint64_t;

constexpr u64 prime32_1 = 0x9E3779B1, prime32_2 = 0x85EBCA77, prime32_3 = 0xC2B2AE3D;
constexpr u64 prime64_1 = 0x9E3779B185EBCA87, prime64_2 = 0xC2B2AE3D27D4EB4F, prime64_3 = 0x165667B19E3779F9,
              prime64_4 = 0x85EBCA77C2B2AE63, prime64_5 = 0x27D4EB2F165667C5;
constexpr u64 mix_1 = 0x165667919E3779F9, mix_2 = 0x9FB21C651E98DF25;

constexpr std::size_t secret_size = 192;
constexpr std::array<unsigned char, secret_size> secret = {
    0xb8, 0xfe, 0x6c, 0x39, 0x23, 0xa4, 0x4b, 0xbe, 0x7c, 0x01, 0x81, 0x2c, 0xf7, 0x21, 0xad, 0x1c, 0xde, 0xd4,
    0x6d, 0xe9, 0x83, 0x90, 0x97, 0xdb, 0x72, 0x40, 0xa4, 0xa4, 0xb7, 0xb3, 0x67, 0x1f, 0xcb, 0x79, 0xe6, 0x4e,
    0xcc, 0xc0, 0xe5, 0x78, 0x82, 0x5a, 0xd0, 0x7d, 0xcc, 0xff, 0x72, 0x21, 0xb8, 0x08, 0x46, 0x74, 0xf7, 0x43,
    0x24, 0x8e, 0xe0, 0x35, 0x90, 0xe6, 0x81, 0x3a, 0x26, 0x4c, 0x3c, 0x28, 0x52, 0xbb, 0x91, 0xc3, 0x00, 0xcb,
    0x88, 0xd0, 0x65, 0x8b, 0x1b, 0x53, 0x2e, 0xa3, 0x71, 0x64, 0x48, 0x97, 0xa2, 0x0d, 0xf9, 0x4e, 0x38, 0x19,
    0xef, 0x46, 0xa9, 0xde, 0xac, 0xd8, 0xa8, 0xfa, 0x76, 0x3f, 0xe3, 0x9c, 0x34, 0x3f, 0xf9, 0xdc, 0xbb, 0xc7,
    0xc7, 0x0b, 0x4f, 0x1d, 0x8a, 0x51, 0xe0, 0x4b, 0xcd, 0xb4, 0x59, 0x31, 0xc8, 0x9f, 0x7e, 0xc9, 0xd9, 0x78,
    0x73, 0x64, 0xea, 0xc5, 0xac, 0x83, 0x34, 0xd3, 0xeb, 0xc3, 0xc5, 0x81, 0xa0, 0xff, 0xfa, 0x13, 0x63, 0xeb,
    0x17, 0x0d, 0xdd, 0x51, 0xb7, 0xf0, 0xda, 0x49, 0xd3, 0x16, 0x55, 0x26, 0x29, 0xd4, 0x68, 0x9e, 0x2b, 0x16,
    0xbe, 0x58, 0x7d, 0x47, 0xa1, 0xfc, 0x8f, 0xf8, 0xb8, 0xd1, 0x7a, 0xd0, 0x31, 0xce, 0x45, 0xcb, 0x3a, 0x8f,
    0x95, 0x16, 0x04, 0x28, 0xaf, 0xd7, 0xfb, 0xca, 0xbb, 0x4b, 0x40, 0x7e,
};

template <class T>
T load(const std::byte* p) {
    static_assert(std::endian::native == std::endian::little);
    T value;
    std::memcpy(&value, p, sizeof value);
    return value;
}
u64 load64(const std::byte* p) {
    return load<u64>(p);
}
u64 load32(const std::byte* p) {
    return load<u32>(p);
}
const std::byte* key(std::size_t offset) {
    return reinterpret_cast<const std::byte*>(secret.data()) + offset;
}

constexpr u64 swapped(u64 v) {
    u64 out = 0;
    for (int i = 0; i < 8; ++i) out = out << 8 | (v >> (8 * i) & 0xff);
    return out;
}

/// Low and high half of the 128-bit product, combined by exclusive or.
constexpr u64 folded_product(u64 a, u64 b) {
    const u64 a0 = a & 0xffffffff, a1 = a >> 32, b0 = b & 0xffffffff, b1 = b >> 32;
    const u64 low = a0 * b0, cross = (low >> 32) + (a1 * b0 & 0xffffffff) + a0 * b1;
    const u64 high = (a1 * b0 >> 32) + (cross >> 32) + a1 * b1;
    return (cross << 32 | (low & 0xffffffff)) ^ high;
}

constexpr u64 avalanche(u64 h) {
    h = (h ^ h >> 37) * mix_1;
    return h ^ h >> 32;
}
constexpr u64 strong_avalanche(u64 h) {
    h = (h ^ h >> 33) * prime64_2;
    h = (h ^ h >> 29) * prime64_3;
    return h ^ h >> 32;
}

u64 hash_0_to_16(const std::byte* p, std::size_t size, u64 seed) {
    if (size > 8) {
        const u64 low = load64(p) ^ ((load64(key(24)) ^ load64(key(32))) + seed);
        const u64 high = load64(p + size - 8) ^ ((load64(key(40)) ^ load64(key(48))) - seed);
        return avalanche(size + swapped(low) + high + folded_product(low, high));
    }
    if (size >= 4) {
        seed ^= swapped(seed & 0xffffffff);
        u64 h = (load32(p + size - 4) + (load32(p) << 32)) ^ ((load64(key(8)) ^ load64(key(16))) - seed);
        h = (h ^ std::rotl(h, 49) ^ std::rotl(h, 24)) * mix_2;
        h = (h ^ ((h >> 35) + size)) * mix_2;
        return h ^ h >> 28;
    }
    if (size > 0) {
        const auto byte = [p](std::size_t i) { return static_cast<u64>(p[i]); };
        const u64 combined = byte(0) << 16 | byte(size / 2) << 24 | byte(size - 1) | size << 8;
        return strong_avalanche(combined ^ ((load32(key(0)) ^ load32(key(4))) + seed));
    }
    return strong_avalanche(seed ^ load64(key(56)) ^ load64(key(64)));
}

u64 mix_16(const std::byte* p, const std::byte* with, u64 seed) {
    return folded_product(load64(p) ^ (load64(with) + seed), load64(p + 8) ^ (load64(with + 8) - seed));
}

u64 hash_17_to_128(const std::byte* p, std::size_t size, u64 seed) {
    u64 h = size * prime64_1;
    for (std::size_t i = (size - 1) / 32 + 1; i-- > 0;)  // pairs of 16 bytes from both ends, the inner ones first
        h += mix_16(p + 16 * i, key(32 * i), seed) + mix_16(p + size - 16 * (i + 1), key(32 * i + 16), seed);
    return avalanche(h);
}

u64 hash_129_to_240(const std::byte* p, std::size_t size, u64 seed) {
    u64 h = size * prime64_1;
    for (std::size_t i = 0; i < 8; ++i) h += mix_16(p + 16 * i, key(16 * i), seed);
    h = avalanche(h);
    for (std::size_t i = 8; i < size / 16; ++i) h += mix_16(p + 16 * i, key(16 * (i - 8) + 3), seed);
    return avalanche(h + mix_16(p + size - 16, key(136 - 17), seed));
}

constexpr std::size_t stripe = 64, stripes_a_round = (secret_size - stripe) / 8;
using Lanes = std::array<u64, stripe / 8>;

void accumulate(Lanes& lanes, const std::byte* p, const std::byte* with) {
    for (std::size_t i = 0; i < lanes.size(); ++i) {
        const u64 value = load64(p + 8 * i), keyed = value ^ load64(with + 8 * i);
        lanes[i ^ 1] += value;
        lanes[i] += (keyed & 0xffffffff) * (keyed >> 32);
    }
}

void scramble(Lanes& lanes, const std::byte* with) {
    for (std::size_t i = 0; i < lanes.size(); ++i)
        lanes[i] = (lanes[i] ^ lanes[i] >> 47 ^ load64(with + 8 * i)) * prime32_1;
}

u64 hash_long(std::span<const std::byte> head, std::span<const std::byte> rest, u64 seed) {
    std::array<std::byte, secret_size> with;
    for (std::size_t i = 0; i < secret_size; i += 8) {
        const u64 word = i % 16 == 0 ? load64(key(i)) + seed : load64(key(i)) - seed;
        std::memcpy(with.data() + i, &word, sizeof word);
    }
    std::array<std::byte, stripe> first;
    std::memcpy(first.data() + head.size(), rest.data(), stripe - head.size());
    if (!head.empty()) std::memcpy(first.data(), head.data(), head.size());

    Lanes lanes = {prime32_3, prime64_1, prime64_2, prime64_3, prime64_4, prime32_2, prime64_5, prime32_1};
    accumulate(lanes, first.data(), with.data());
    const std::size_t size = head.size() + rest.size();
    for (std::size_t i = 1; i < (size - 1) / stripe; ++i) {
        if (i % stripes_a_round == 0) scramble(lanes, with.data() + secret_size - stripe);
        accumulate(lanes, rest.data() + (i * stripe - head.size()), with.data() + 8 * (i % stripes_a_round));
    }
    if ((size - 1) / stripe % stripes_a_round == 0) scramble(lanes, with.data() + secret_size - stripe);
    accumulate(lanes, rest.data() + (rest.size() - stripe), with.data() + secret_size - stripe - 7);

    u64 h = size * prime64_1;
    for (std::size_t i = 0; i < lanes.size(); i += 2)
        h += folded_product(lanes[i] ^ load64(with.data() + 11 + 8 * i),
                            lanes[i + 1] ^ load64(with.data() + 19 + 8 * i));
    return avalanche(h);
}

constexpr std::size_t longest_short = 240;

u64 hash_short(const std::byte* p, std::size_t size, u64 seed) {
    if (size <= 16) return hash_0_to_16(p, size, seed);
    return size <= 128 ? hash_17_to_128(p, size, seed) : hash_129_to_240(p, size, seed);
}

}  // namespace

std::uint64_t xxh3_64(std::span<const std::byte> bytes, std::uint64_t seed) {
    return bytes.size() <= longest_short ? hash_short(bytes.data(), bytes.size(), seed) : hash_long({}, bytes, seed);
}

std::uint64_t xxh3_64(std::span<const std::byte> head, std::span<const std::byte> rest, std::uint64_t seed) {
    if (head.size() + rest.size() > longest_short) return hash_long(head, rest, seed);
    std::array<std::byte, longest_short> joined;
    std::copy(rest.begin(), rest.end(), std::copy(head.begin(), head.end(), joined.begin()));
    return hash_short(joined.data(), head.size() + rest.size(), seed);
}

}  // namespace fagorc::player
