// Parameters in texts: the forms that the manual prints for WRITE and MSG (8055 T 12.2, 12.8).
#include "passes/execute/texts.hpp"

#include <map>

#include <gtest/gtest.h>

namespace fagorc::passes {
namespace {

std::optional<double> value(double number) {
    static const std::map<double, double> values = {{22, 22}, {100, 10}, {101, 20}, {102, 55}, {103, 222}, {104, 25}};
    const auto at = values.find(number);
    return at == values.end() ? std::nullopt : std::optional(at->second);
}

TEST(WrittenBlock, ReplacesEveryParameterOfAnIsoText) {
    EXPECT_EQ(written_block(" G1 XP100 ZP101 F100", value), " G1 X10 Z20 F100");
    EXPECT_EQ(written_block("X P 100", value), "X 10");
    EXPECT_EQ(written_block("M30", value), "M30");
    EXPECT_EQ(written_block(";", value), ";");
}

TEST(WrittenBlock, ReplacesInAStatementOnlyWhatIsMarked) {
    EXPECT_EQ(written_block(" (SUB P102)", value), " (SUB P102)");
    EXPECT_EQ(written_block(" (SUB ?P102)", value), " (SUB 55)");
    EXPECT_EQ(written_block("(ORGX54=P103)", value), "(ORGX54=P103)");
    EXPECT_EQ(written_block("(ORGX54=?P103)", value), "(ORGX54=222)");
    EXPECT_EQ(written_block("(PCALL ?P104)", value), "(PCALL 25)");
}

TEST(WrittenBlock, KeepsTheParameterBehindADollarAndAnAxis) {
    EXPECT_EQ(written_block("XP22", value), "X22");
    EXPECT_EQ(written_block("X$P100", value), "XP100");
    EXPECT_EQ(written_block("$P100", value), "$P100");
    EXPECT_EQ(written_block("$ P22", value), "$22");
    EXPECT_EQ(written_block("$3000", value), "$3000");
}

TEST(WrittenBlock, HasNoTextWithoutTheValue) { EXPECT_EQ(written_block("XP7", value), std::nullopt); }

TEST(MarkedValues, ReplaceTheMarkedParametersOfAMessage) {
    EXPECT_EQ(with_marked_values("SELECT T?P103", value), "SELECT T222");
    EXPECT_EQ(with_marked_values("P103 ?", value), "P103 ?");
}

TEST(Written, HasUpToFiveDecimalsAndNoZerosAtTheEnd) {
    EXPECT_EQ(written(10), "10");
    EXPECT_EQ(written(-0.1), "-0.1");
    EXPECT_EQ(written(1.0 / 3), "0.33333");
    EXPECT_EQ(written(-0.000001), "0");
    EXPECT_EQ(written(100000), "100000");
    EXPECT_EQ(written(2.0000049), "2");
}

}  // namespace
}  // namespace fagorc::passes
