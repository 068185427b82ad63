// Operators on 32 bits: values worked out by hand.
#include "passes/execute/bits.hpp"

#include <cmath>

#include <gtest/gtest.h>

namespace fagorc::passes::bits {
namespace {

TEST(Bits, BinaryOperatorsAreUnsigned32) {
    EXPECT_EQ(and_(12, 10, false), 8);
    EXPECT_EQ(or_(12, 3, false), 15);
    EXPECT_EQ(xor_(12, 10, false), 6);
    EXPECT_EQ(not_(10, false), 4294967285.0);                  // 2^32 - 11
    EXPECT_EQ(and_(-1, 4294967294.0, false), 4294967294.0);    // -1 is $FFFFFFFF
    EXPECT_EQ(or_(5.9, 0, false), 5);                          // a fraction is cut off
}

TEST(Bits, ConditionsAreLogical) {
    EXPECT_EQ(not_(1, true), 0);
    EXPECT_EQ(not_(0, true), 1);
    EXPECT_EQ(and_(1, 1, true), 1);
    EXPECT_EQ(or_(0, 0, true), 0);
    EXPECT_EQ(xor_(1, 1, true), 0);
}

TEST(Bits, AnUnknownOperandIsUnknownUnlessTheOtherDecides) {
    const double unknown = std::nan("");
    EXPECT_TRUE(std::isnan(and_(unknown, 3, false)));
    EXPECT_EQ(and_(unknown, 0, false), 0);
    EXPECT_EQ(or_(unknown, 1, true), 1);
    EXPECT_TRUE(std::isnan(or_(unknown, 1, false)));
    EXPECT_TRUE(std::isnan(xor_(1, unknown, true)));
    EXPECT_TRUE(std::isnan(not_(unknown, false)));
}

TEST(Bits, BcdPacksDigitsAndBinUnpacksThem) {
    EXPECT_EQ(bcd(234), 564);              // 8055 T 11.4: BCD 234 = $234 = 564
    EXPECT_EQ(bin(171), 171);              // 8055 T 11.4: BIN $AB = 171
    EXPECT_EQ(bin(564), 234);
    EXPECT_EQ(bcd(99999999), 2576980377.0);   // $99999999
    EXPECT_EQ(bcd(100000000), std::nullopt);
    EXPECT_EQ(bcd(-1), std::nullopt);
}

}  // namespace
}  // namespace fagorc::passes::bits
