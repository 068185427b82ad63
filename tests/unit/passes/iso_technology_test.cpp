// F S T D M (8055 T 5, 8.1): values, limits, the machine's tables, subroutines of M and T.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/passes/iso_rig.hpp"

namespace fagorc::passes::testing {
namespace {

using operation::Event;
using operation::Line;

std::string alarm_of(std::string_view blocks) {
    return IsoRig().run(blocks).alarm();
}

/// Kinds and values of the events in the order sent; motion counts as -1.
std::vector<double> order_of(const IsoRig& b) {
    std::vector<double> list;
    for (const auto& o : b.out.list) {
        if (const auto* e = std::get_if<Event>(&o.what)) list.push_back(e->value);
        if (operation::is_motion(o.what)) list.push_back(-1);
    }
    return list;
}

TEST(IsoTechnology, FeedsByMode) {
    IsoRig b;
    b.run("S500 M3\nG01 X1 F100\nG95 X2 F0.2");
    EXPECT_EQ(b.last_move().at.feed, 0.2);
    b.run("G94 X3");
    EXPECT_EQ(b.last_move().at.feed, 100) << "each mode keeps its feed";
    EXPECT_EQ(alarm_of("G01 X10 F-100"), "0246");
}

TEST(IsoTechnology, NoFeedIsAWarningOrAnError) {
    IsoRig b;
    b.run("G01 X10\nX20");
    EXPECT_EQ(b.warnings(), std::vector<std::string>{"feed_is_highest"});
    EXPECT_EQ(b.last_move().at.feed, 0);
    auto lathe = built_in_lathe();
    lathe.feed_zero_is_error = true;
    EXPECT_EQ(IsoRig(lathe).run("G01 X10").alarm(), "1073");
    EXPECT_EQ(IsoRig(lathe).run("G01 X10 F0").alarm(), "0246");
    EXPECT_EQ(IsoRig(lathe).run("G00 X10").alarm(), "");
}

TEST(IsoTechnology, FeedPerRevolutionNeedsASpeed) {
    EXPECT_EQ(alarm_of("G95 G90 G01 X10 F0.2"), "1036");
    EXPECT_EQ(alarm_of("G95 F0.2\nG00 X10"), "");
    EXPECT_EQ(alarm_of("G95 F0.2\nG01 X10 S100"), "");
    EXPECT_EQ(alarm_of("G95 G02 X10 Z5 R10 F0.2"), "1036");
}

TEST(IsoTechnology, ConstantSurfaceSpeed) {
    IsoRig b;
    b.run("G96 S150 M3\nG95 G01 X50 F0.2");
    EXPECT_EQ(b.last_move().at.speed, 150);
    EXPECT_EQ(b.state(b.last_move()).modal.speed, program::SpeedMode::constant_surface);
    b.run("G97\nX51");  // the present speed stays: 1000 * 150 / (pi * 50)
    EXPECT_NEAR(b.last_move().at.speed, 954.9297, 5e-5);
    b.run("S500\nG96\nX52");  // the last surface speed
    EXPECT_EQ(b.last_move().at.speed, 150);
    b.run("G00 X0\nG97\nG01 Z1");  // at the centre: the highest speed of the gear
    EXPECT_EQ(b.last_move().at.speed, 6000);
    EXPECT_EQ(alarm_of("G96 M3"), "surface_speed_missing");
    IsoRig feet;
    feet.run("G70 G96 S100 M3\nG01 X2 F1");
    EXPECT_NEAR(feet.last_move().at.speed, 30.48, 1e-12);
}

TEST(IsoTechnology, SpeedLimits) {
    EXPECT_EQ(alarm_of("M41\nS99999 M3"), "1035");
    EXPECT_EQ(alarm_of("G92 S1000\nS2000 M3"), "speed_above_limit");
    EXPECT_EQ(alarm_of("G92 S1000\nG96 S2000 M3"), "") << "metres a minute";
    EXPECT_EQ(alarm_of("S-5"), "0151");
    auto lathe = built_in_lathe();
    lathe.policy.s_over_limit = machine::Policies::OverLimit::clamp;
    IsoRig b(lathe);
    b.run("G92 S1000\nS2000 M3\nG01 X1 F1");
    EXPECT_EQ(b.last_move().at.speed, 1000);
    EXPECT_EQ(b.state(b.last_move()).speed_limit, 1000);
    lathe.gear_rpm = {1000, 2000, 3000, 4000};
    EXPECT_EQ(IsoRig(lathe).run("S1500 M3").alarm(), "1035");
    EXPECT_EQ(IsoRig(lathe).run("S1500 M42").alarm(), "") << "the gear of the same block counts";
}

TEST(IsoTechnology, AutomaticGears) {
    auto lathe = built_in_lathe();
    lathe.automatic_gears = true;
    lathe.gear_rpm = {1000, 2000, 2000, 2000};
    IsoRig b(lathe);
    b.run("S1500 M3\nG01 X1 F1");
    EXPECT_EQ(b.state(b.last_move()).gear, 2);
    EXPECT_EQ(IsoRig(lathe).run("S2500 M3").alarm(), "1035");
    lathe.misc[42].subroutine = 9942;
    EXPECT_EQ(IsoRig(lathe).run("S1500 M3").alarm(), "1031");
    IsoRig alone(lathe);
    alone.run("S1500");
    EXPECT_EQ(alone.outcome.subroutine, 9942u);
}

TEST(IsoTechnology, ToolTakesItsOffset) {
    auto lathe = built_in_lathe();
    lathe.tools[3].offset = 12;
    IsoRig b(lathe);
    b.run("T5 D18");
    EXPECT_EQ(b.variable("TOD"), 18);
    b.run("T3");
    EXPECT_EQ(b.variable("TOD"), 12);
    b.run("D22");
    EXPECT_EQ(b.variable("TOOL"), 3);
    EXPECT_EQ(b.variable("TOD"), 22);
    b.run("T7");
    EXPECT_EQ(b.variable("TOD"), 7);
    EXPECT_EQ(alarm_of("T1 D999"), "0185");
    EXPECT_EQ(alarm_of("T100"), "1015");
    EXPECT_EQ(alarm_of("T0"), "");
    EXPECT_EQ(alarm_of("T1.5"), "0153");
    EXPECT_EQ(alarm_of("T-1"), "0151");
}

TEST(IsoTechnology, LengthsOfTheSheetsExample) {
    // 8055 T 8.1: TOX 40, TOZ 25, I -0.2, K 0.05: reference = part + 39.9 and + 25.05.
    auto lathe = built_in_lathe();
    lathe.offsets[1] = {.x = 40, .z = 25, .nose = 0.8, .tip = 3, .wear_x = -0.2, .wear_z = 0.05};
    IsoRig b(lathe);
    b.run("G90 G00 X200 Z100\nX50 T1");  // Z is not programmed: the turret stays, the tip is shorter by the length
    EXPECT_NEAR(b.last<Line>().end.v, 25, 1e-12);
    EXPECT_NEAR(b.last<Line>().end.u, 74.95, 1e-12);
    EXPECT_NEAR(b.state(b.last_move()).length_x, 39.9, 1e-12);
    EXPECT_EQ(b.state(b.last_move()).nose, 0.8);
    EXPECT_EQ(b.variable("PPOS", Axis::Z), 100) << "the programmed point does not change";
    b.run("G91 Z-10");
    EXPECT_NEAR(b.last<Line>().end.u, 90, 1e-12);
    b.run("D0\nX0");
    EXPECT_NEAR(b.last<Line>().end.u, 90 + 25.05, 1e-12);
    lathe.policy.wear_x = machine::Policies::WearX::radius;
    IsoRig radius(lathe);
    radius.run("T1\nG00 X0 Z0");
    EXPECT_NEAR(radius.state(radius.last_move()).length_x, 39.8, 1e-12);
}

TEST(IsoTechnology, ToolWaitsForM06WhereTheMachineSaysSo) {
    auto lathe = built_in_lathe();
    lathe.tool_needs_m06 = true;
    IsoRig b(lathe);
    b.run("T4");
    EXPECT_EQ(b.variable("TOOL"), 0);
    EXPECT_EQ(b.variable("NXTOOL"), 4);
    EXPECT_EQ(b.variable("NXTOD"), 4);
    b.run("M06");
    EXPECT_EQ(b.variable("TOOL"), 4);
    EXPECT_EQ(b.variable("TOD"), 4);
    b.run("T5 M06");
    EXPECT_EQ(b.variable("TOOL"), 5);
    EXPECT_EQ(alarm_of("T3 D3 M06"), "0011") << "T and M06 admit nothing else";
}

TEST(IsoTechnology, OrderAroundTheMotion) {
    IsoRig b;
    b.run("G01 X10 F100 S500 T3 M3 M8 M5");
    EXPECT_EQ(order_of(b), (std::vector<double>{3, 3, 3, 8, -1, 5}));  // T, D, M3, M8, the move, M5
    EXPECT_EQ(b.state(b.last_move()).turn, operation::SpindleTurn::clockwise);
    EXPECT_EQ(b.state(b.out.list.back()).turn, operation::SpindleTurn::stopped);
    IsoRig dwells;
    dwells.run("G04 K10 X5 M8");
    ASSERT_EQ(dwells.out.list.size(), 3u);
    EXPECT_TRUE(std::holds_alternative<operation::Dwell>(dwells.out.list[0].what));
}

TEST(IsoTechnology, TableOfTheMachineDecides) {
    auto lathe = built_in_lathe();
    lathe.misc[8].before = false;
    lathe.misc[8].stops = true;
    lathe.misc[5].before = true;
    IsoRig b(lathe);
    b.run("G00 X10 M5 M8");
    EXPECT_EQ(order_of(b), (std::vector<double>{5, -1, 8}));
    EXPECT_TRUE(std::holds_alternative<operation::Barrier>(b.out.list.back().what));
    lathe.misc.clear();
    IsoRig empty(lathe);
    empty.run("G00 X10 M5 M8");
    EXPECT_EQ(order_of(empty), (std::vector<double>{8, -1, 5})) << "stops come after the motion by default";
}

TEST(IsoTechnology, SpindleOrientationAndLiveTool) {
    IsoRig b;
    b.run("S1000 M3\nM19 S-30");
    EXPECT_EQ(b.last<Event>().kind, Event::Kind::spindle_angle);
    EXPECT_EQ(b.last<Event>().value, -30);
    b.run("M19");
    EXPECT_EQ(b.last<Event>().value, 0);
    EXPECT_EQ(b.state(b.out.list.back()).turn, operation::SpindleTurn::oriented);
    EXPECT_EQ(b.variable("PRGS"), 1000) << "the S of M19 is no speed";
    b.run("M45 S-500");
    EXPECT_EQ(b.last<Event>().kind, Event::Kind::live_tool);
    EXPECT_EQ(b.last<Event>().value, -500);
    auto lathe = built_in_lathe();
    lathe.live_tool = false;
    EXPECT_EQ(IsoRig(lathe).run("M45 S500").alarm(), "0189");
}

TEST(IsoTechnology, SubroutineOfAnM) {
    auto lathe = built_in_lathe();
    lathe.misc[10].subroutine = 9910;
    IsoRig b(lathe);
    b.run("M10");
    EXPECT_EQ(b.outcome.subroutine, 9910u);
    EXPECT_TRUE(order_of(b).empty());
    b.run("M10");  // inside its subroutine: without another call
    EXPECT_FALSE(b.outcome.subroutine);
    EXPECT_EQ(order_of(b), std::vector<double>{10});
    program::BlockTemplate shape;
    program::Block block{&shape, {}, "M10", {0, 7}, {}};
    b.session.block = &block;
    EXPECT_FALSE(b.runner.subroutine_ended());
    EXPECT_EQ(order_of(b), (std::vector<double>{10, 10})) << "sent after its subroutine";
    EXPECT_EQ(b.out.list.back().at.line, 7u);
    EXPECT_EQ(IsoRig(lathe).run("G00 X1 M10").alarm(), "0011");
    EXPECT_EQ(IsoRig(lathe).run("M8 M10").alarm(), "0011");
    lathe.misc[10].m_after_subroutine = false;
    IsoRig first(lathe);
    first.run("M10");
    EXPECT_EQ(order_of(first), std::vector<double>{10});
}

TEST(IsoTechnology, SubroutinesOfTAndM06InOneBlock) {
    auto lathe = built_in_lathe();
    lathe.tool_subroutine = 9901;
    lathe.tool_needs_m06 = true;
    lathe.misc[6].subroutine = 9906;
    EXPECT_EQ(IsoRig(lathe).run("X10 T1").alarm(), "0184");
    EXPECT_EQ(IsoRig(lathe).run("T1 D2").alarm(), "");
    IsoRig b(lathe);
    b.run("T1 M06");
    EXPECT_EQ(b.outcome.subroutine, 9901u);
    program::BlockTemplate shape;
    program::Block block{&shape, {}, "T1 M06", {0, 1}, {}};
    b.session.block = &block;
    EXPECT_EQ(b.runner.subroutine_ended(), 9906u);
    EXPECT_FALSE(b.runner.subroutine_ended());
    EXPECT_EQ(b.variable("TOOL"), 1);
}

TEST(IsoTechnology, NumberOfAnMByParameter) {
    IsoRig b;
    *b.session.parameters.find(1) = 8;
    b.run("MP1");
    EXPECT_EQ(order_of(b), std::vector<double>{8});
    *b.session.parameters.find(1) = 10000;
    EXPECT_EQ(b.run("MP1").alarm(), "unknown_misc");
}

}  // namespace
}  // namespace fagorc::passes::testing
