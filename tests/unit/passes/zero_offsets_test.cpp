// The interplay of G54..G59, G158, G159, G92 and G53 as the manual's tables of offsets tell it (8055 T 4.4.1 to 4.4.2).
#include "passes/execute/zero_offsets.hpp"

#include <gtest/gtest.h>

namespace fagorc::passes {
namespace {

PerAxis<double> xz(double x, double z) {
    PerAxis<double> v{};
    v[Axis::X] = x;
    v[Axis::Z] = z;
    return v;
}

AxisValues words(std::initializer_list<std::pair<Axis, double>> list) {
    AxisValues v;
    for (auto [a, value] : list) v.set(a, value);
    return v;
}

TEST(ZeroOffsets, TableSequenceOfTheManual) {
    // G54 Z330, G55 Z240, G58 Z-90, G59 Z-180: G54 / G58 / G59 / G55 gives 330, 240, 150, 240.
    ZeroOffsets o;
    o.select(1, xz(0, 330));
    EXPECT_EQ(o.total()[Axis::Z], 330);
    o.add(5, xz(0, -90));
    EXPECT_EQ(o.total()[Axis::Z], 240);
    EXPECT_EQ(o.row(), 1);
    o.add(6, xz(0, -180));
    EXPECT_EQ(o.total()[Axis::Z], 150);
    o.select(2, xz(0, 240));
    EXPECT_EQ(o.total()[Axis::Z], 240);
    EXPECT_EQ(o.increment()[Axis::Z], 0);
}

TEST(ZeroOffsets, ValuesReplaceAxisByAxisAndOutliveANewAbsoluteOffset) {
    ZeroOffsets o;
    o.select(1, xz(0, 330));
    o.shift(words({{Axis::X, 20}, {Axis::Z, 60}}));
    o.shift(words({{Axis::X, 50}}));
    EXPECT_EQ(o.total(), xz(50, 390));
    o.select(2, xz(0, 240));
    EXPECT_EQ(o.total(), xz(50, 300));
    o.shift(words({{Axis::Z, 0}}));
    EXPECT_EQ(o.total(), xz(50, 240));
    o.shift({});
    EXPECT_EQ(o.total(), xz(0, 240));
}

TEST(ZeroOffsets, ValuesAndTableIncrementsExcludeEachOther) {
    ZeroOffsets o;
    o.add(5, xz(1, -90));
    o.shift(words({{Axis::X, 20}}));
    EXPECT_EQ(o.total(), xz(20, 0)) << "the last one programmed wins";
    o.add(6, xz(0, -180));
    EXPECT_EQ(o.total(), xz(0, -180));
    EXPECT_EQ(o.increment_row(), 6);
}

TEST(ZeroOffsets, PresetCountsTheIncrementIn) {
    ZeroOffsets o;
    o.select(3, xz(5, 100));
    o.shift(words({{Axis::Z, 7}}));
    o.preset(Axis::Z, 250, 10);  // machine 250 becomes part 10
    EXPECT_EQ(o.total(), xz(5, 240));
    EXPECT_EQ(o.row(), 0);
    o.shift({});
    EXPECT_EQ(o.total(), xz(5, 233));
    o.cancel();
    EXPECT_EQ(o.total(), xz(0, 0));
}

}  // namespace
}  // namespace fagorc::passes
