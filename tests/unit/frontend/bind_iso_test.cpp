// ISO blocks: header, words, codes and what belongs to them (8055 T chapters 2 and 5).
#include <gtest/gtest.h>

#include "tests/unit/frontend/shapes.hpp"

namespace fagorc {
namespace {

class IsoBlocks : public testing::TestWithParam<BlockCase> {};

TEST_P(IsoBlocks, Bind) {
    EXPECT_EQ(shape_text(GetParam().block), GetParam().shape) << GetParam().block;
}

INSTANTIATE_TEST_SUITE_P(
    Header, IsoBlocks,
    testing::Values(BlockCase{"", ""}, BlockCase{"; a comment", ""},
                    BlockCase{"N10 G1 X10 Z20 F100", "label=#0 modal[G01] X=#1 Z=#2 F=#3"},
                    BlockCase{"/G0 X1", "skip=1 modal[G00] X=#0"},
                    BlockCase{"/1 /3 N0020 X1", "skip=1 skip=3 label=#0 X=#1"},
                    BlockCase{"X10 N3", "X=#0 repeat=#1"}, BlockCase{"N5 G90 N7", "label=#0 modal[G90] repeat=#1"}));

INSTANTIATE_TEST_SUITE_P(
    Words, IsoBlocks,
    testing::Values(BlockCase{"G X", "modal[G00] X"}, BlockCase{"X-P3 Z P4", "X=-P#0 Z=P#1"},
                    BlockCase{"G00 X1 Y2 Z3 U4 V5 W6 A7 B8 C9",
                              "modal[G00] X=#0 Y=#1 Z=#2 U=#3 V=#4 W=#5 A=#6 B=#7 C=#8"},
                    BlockCase{"X1 F2 S3 T4 D5 M3 M8", "X=#0 F=#1 S=#2 T=#3 D=#4 misc[M03 M08]"},
                    BlockCase{"G02 X10 Z20 I5 K0", "modal[G02] X=#0 Z=#1 I=#2 K=#3"},
                    BlockCase{"G91 Q90 R10", "modal[G91] Q=#0 R=#1"}, BlockCase{"Q149 Z110", "Q=#0 Z=#1"},
                    BlockCase{"G33 Z-20 L2 Q0", "modal[G33] Z=#0 L=#1 Q=#2"},
                    // two axes of one plane with the same centre letter: the first I is that of X, the second of U
                    BlockCase{"G02 X10 U5 I1 I2", "modal[G02] X=#0 U=#1 I=#2 I=#3"}));

INSTANTIATE_TEST_SUITE_P(
    CodesWithWordsOfTheirOwn, IsoBlocks,
    testing::Values(BlockCase{"G41 N10 X10 Z5", "modal[G41(N=#0)] X=#1 Z=#2"},
                    BlockCase{"G41 X10 N5", "modal[G41] X=#0 repeat=#1"},
                    BlockCase{"G01 G36 R5 X80 R10", "modal[G01] function[G36(R=#0)] X=#1 R=#2"},
                    BlockCase{"G04 K100", "function[G04(K=#0)]"}, BlockCase{"G04 K", "function[G04(K)]"},
                    BlockCase{"G04", "function[G04]"}, BlockCase{"G92 X10 Z0", "function[G92(X=#0 Z=#1)]"},
                    BlockCase{"G92 S1000", "function[G92(S=#0)]"}, BlockCase{"G159 N3", "modal[G159(N=#0)]"},
                    BlockCase{"G16 XZ", "modal[G16(X Z)]"}, BlockCase{"G74 Z X", "function[G74(Z X)]"},
                    BlockCase{"G51 A50 E0.1 B30", "modal[G51(A=#0 E=#1 B=#2)]"},
                    BlockCase{"M19 S-30", "misc[M19(S=#0)]"}, BlockCase{"M45 S500 M3", "misc[M45(S=#0) M03]"},
                    BlockCase{"S1000 M19", "S=#0 misc[M19]"}, BlockCase{"M123", "misc[M123]"}));

INSTANTIATE_TEST_SUITE_P(
    CyclesTakeAllThatFollows, IsoBlocks,
    testing::Values(BlockCase{"G68 X0 Z80 C5 D1 L1 M2 K0.5 F100 H50 S10 E20 Q3",
                              "function[G68(X=#0 Z=#1 C=#2 D=#3 L=#4 M=2 K=#5 F=#6 H=#7 S=#8 E=#9 Q=#10)]"},
                    BlockCase{"G68 X0 Z80 C5 M0.5 F100 S10 E20",
                              "function[G68(X=#0 Z=#1 C=#2 M=#3 F=#4 S=#5 E=#6)]"}));

INSTANTIATE_TEST_SUITE_P(CodesByParameter, IsoBlocks,
                         testing::Values(BlockCase{"GP1 X10", "by_parameter"}, BlockCase{"X1 MP1", "X=#0 M=P#1"}));

INSTANTIATE_TEST_SUITE_P(
    Calls, IsoBlocks,
    testing::Values(BlockCase{"G187", "call_by_code(187)"},
                    BlockCase{"G180 A12.3 B=P100 P10=6 S=-5 CP7 D-P8",
                              "call_by_code(180, A = #0, B = P#1, P#2 = #3, S = #4, C = P#5, D = negate(P#6))"},
                    // every letter is a parameter, G and M too
                    BlockCase{"G380 M3 G1 X2 P=4", "call_by_code(380, M = 3, G = 1, X = #0, P = #1)"}));

TEST(IsoBlocks, SayWhetherAnAxisCanMove) {
    const auto moves = [](const char* block) { return std::get<program::IsoBlock>(shape_of(block).body).has_axis; };
    EXPECT_TRUE(moves("X10"));
    EXPECT_TRUE(moves("G01 Q30 R5"));
    EXPECT_FALSE(moves("G92 X10"));
    EXPECT_FALSE(moves("F100 S500 M3"));
    EXPECT_FALSE(moves("G01 G36 R5"));  // R is the radius of the corner
}

TEST(IsoBlocks, MarkTheWordsByTheirTokens) {
    const auto shape = shape_of("N10 G1 X-P3 Z5");  // N 10 G1 X - P 3 Z 5
    const auto& block = std::get<program::IsoBlock>(shape.body);
    const auto words = shape.run(block.geometry);
    EXPECT_EQ(block.modal[0].token, 2);
    EXPECT_EQ(words[0].token, 3);
    EXPECT_EQ(words[0].end_token, 7);
    EXPECT_EQ(words[1].token, 7);
    EXPECT_EQ(words[1].end_token, 9);
}

}  // namespace
}  // namespace fagorc
