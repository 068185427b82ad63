// The shape cache: one call of the maker a shape, bounded, and no difference when it is off.
#include "frontend/shape/cache.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/unit/frontend/text_side.hpp"

namespace fagorc::frontend {
namespace {

/// Keys that all differ: letters of the base-26 digits of n.
std::string key_of(unsigned n) {
    std::string key;
    do key += static_cast<char>('A' + n % 26);
    while (n /= 26);
    return key + "#";
}

TEST(ShapeCache, AKeyIsMadeOnce) {
    PlainMaker maker;
    ShapeCache cache(maker, true);
    program::BlockTemplate own;
    std::vector<const program::BlockTemplate*> made;
    for (unsigned n = 0; n < 3000; ++n) made.push_back(&cache.find(key_of(n), own));
    EXPECT_EQ(maker.calls, 3000u);
    EXPECT_EQ(cache.shapes(), 3000u);
    for (unsigned n = 3000; n-- > 0;) EXPECT_EQ(&cache.find(key_of(n), own), made[n]) << n;  // growing moved none
    EXPECT_EQ(maker.calls, 3000u);
    EXPECT_EQ(cache.shapes(), 3000u);
}

TEST(ShapeCache, NeighboursOfOneShapeAndTheEmptyKey) {
    PlainMaker maker;
    ShapeCache cache(maker, true);
    program::BlockTemplate own;
    for (int i = 0; i < 5; ++i) cache.find("N#", own);
    for (int i = 0; i < 5; ++i) cache.find("", own);
    cache.find(std::string("N#\0", 3), own);  // a payload byte of zero is a difference
    EXPECT_EQ(maker.calls, 3u);
}

TEST(ShapeCache, BeyondItsLimitItKeepsNothingAndForgetsNothing) {
    PlainMaker maker;  // a template says that it holds 1000 bytes
    ShapeCache cache(maker, true, 10 * 1000);
    program::BlockTemplate own;
    unsigned kept = 0;
    for (unsigned n = 0; n < 100; ++n) kept += &cache.find(key_of(n), own) != &own;
    EXPECT_GE(kept, 8u);
    EXPECT_LE(kept, 10u);
    EXPECT_EQ(maker.calls, 100u);
    EXPECT_NE(&cache.find(key_of(0), own), &own);
    EXPECT_EQ(maker.calls, 100u);
    EXPECT_EQ(&cache.find(key_of(99), own), &own);
    EXPECT_EQ(maker.calls, 101u);
    EXPECT_EQ(cache.shapes(), 101u);
}

TEST(ShapeCache, SwitchedOffItMakesEachTime) {
    PlainMaker maker;
    ShapeCache cache(maker, false);
    program::BlockTemplate own;
    for (int i = 0; i < 7; ++i) EXPECT_EQ(cache.find("N#", own).label_slot, std::optional<std::uint16_t>(0));
    EXPECT_EQ(maker.calls, 7u);
    EXPECT_EQ(cache.shapes(), 7u);
}

}  // namespace
}  // namespace fagorc::frontend
