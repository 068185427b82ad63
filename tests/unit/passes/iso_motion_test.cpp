// Straight moves, polar and angle forms, rotary axes, threads (8055 T 3, 6.1, 6.2, 6.12). Numbers by hand or from the
// manual's drawings; X as a radius in all results.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/passes/iso_rig.hpp"

namespace fagorc::passes::testing {
namespace {

using operation::Line;
using operation::Thread;

void expect_end(const IsoRig& b, double z, double x) {
    const auto& line = b.last<Line>();
    EXPECT_NEAR(line.end.u, z, 1e-9);
    EXPECT_NEAR(line.end.v, x, 1e-9);
}

std::string alarm_of(std::string_view blocks) {
    return IsoRig().run(blocks).alarm();
}

TEST(IsoMotion, AbsoluteCoordinatesAndDiameters) {
    IsoRig b;
    b.run("G90 G00 X100 Z20");
    expect_end(b, 20, 50);
    EXPECT_TRUE(b.last<Line>().rapid);
    EXPECT_TRUE(b.outcome.moved);
    b.run("G152\nG01 X30 F150");
    expect_end(b, 20, 30);
    EXPECT_FALSE(b.last<Line>().rapid);
    EXPECT_EQ(b.last_move().at.feed, 150);
    EXPECT_EQ(b.last_move().at.line, 2u);
    b.run("Z-7.5");
    expect_end(b, -7.5, 30);
}

TEST(IsoMotion, IncrementsAreDiameterIncrements) {
    IsoRig b;
    b.run("G90 G00 X200 Z60\nG91 G01 X-40 F100");
    expect_end(b, 60, 80);  // 8055 T 3.4: from X200 to X160
    b.run("G152 X5 Z-10");
    expect_end(b, 50, 85);
}

TEST(IsoMotion, InchesOfEachWord) {
    IsoRig b;
    b.run("G70 G90 G01 X2 Z1 F10");
    expect_end(b, 25.4, 25.4);
    EXPECT_DOUBLE_EQ(b.last_move().at.feed, 254);
    b.run("C90");  // degrees, and degrees a minute
    EXPECT_NEAR(b.last_move().others[Axis::C], 90, 1e-12);
    EXPECT_NEAR(b.last_move().at.feed, 10, 1e-12);
    EXPECT_EQ(alarm_of("G70 G00 X4000"), "0159");
}

TEST(IsoMotion, AxesOutsideThePlaneGoAlong) {
    IsoRig b;
    b.run("G90 G01 X10 Y5 W-3 F100");
    EXPECT_EQ(b.last_move().others[Axis::Y], 5);
    EXPECT_EQ(b.last_move().others[Axis::W], -3);
    AxisSet yw;
    yw.add(Axis::Y);
    yw.add(Axis::W);
    EXPECT_EQ(b.last_move().moved, yw);
    b.run("Z1");
    EXPECT_TRUE(b.last_move().moved.empty());
    EXPECT_EQ(b.last_move().others[Axis::Y], 5);
}

TEST(IsoMotion, OtherPlanes) {
    IsoRig b;
    b.run("G17 G90 G152 G01 X10 Y20 Z5 F100");
    EXPECT_EQ(b.last<Line>().end, (Point{10, 20}));
    b.run("G16 W X\nX7 W8");
    EXPECT_EQ(b.last<Line>().end, (Point{8, 7}));
}

TEST(IsoMotion, PolarWordsAboutTheOrigin) {
    // 8055 T 3.6.2 example: R430 Q0, R340 Q45; then increments R-90 Q45.
    IsoRig b;
    b.run("G18 G152 G90 G01 R430 Q0 F100");
    expect_end(b, 430, 0);
    b.run("Q33.7");  // the radius stays
    expect_end(b, 430 * std::cos(radians(33.7)), 430 * std::sin(radians(33.7)));
    b.run("R340 Q45");
    expect_end(b, 340 / std::sqrt(2.0), 340 / std::sqrt(2.0));
    b.run("G91 R-90 Q45");
    expect_end(b, 0, 250);
    b.run("Q-450");
    expect_end(b, 250, 0);  // 90 - 450 = -360
}

TEST(IsoMotion, PolarOriginByValuesHereAndByPlane) {
    IsoRig b;
    b.run("G18 G152 G90 G01 X30 Z50 F100\nG93\nR20 Q90");
    expect_end(b, 50, 50);
    b.run("G93 I10 J40\nR5 Q180");  // I is the abscissa Z, J the ordinate X
    expect_end(b, 5, 40);
    b.run("G151\nG93 I10 J40\nR5 Q0");  // J as an X word: a diameter
    expect_end(b, 15, 20);
    b.run("G17\nG18\nR5 Q0");  // a change of plane brings the part zero back
    expect_end(b, 5, 0);
}

TEST(IsoMotion, PolarErrors) {
    EXPECT_EQ(alarm_of("G90 G01 R-10 Q20 F100"), "0162");
    EXPECT_EQ(alarm_of("G90 G01 R10 Q0 F100\nG91 R-20 Q10"), "1078");
    EXPECT_EQ(alarm_of("G90 G53 G01 R10 Q20 F100"), "0045");
    EXPECT_EQ(alarm_of("G90 G01 X10 R20 F100"), "0044");
    EXPECT_EQ(alarm_of("G90 G01 X10 Z10 Q20 F100"), "0044");
    EXPECT_EQ(alarm_of("G90 G01 X20 K-15 F100"), "0044");
}

TEST(IsoMotion, PolarWithAThirdAxis) {
    IsoRig b;
    b.run("G18 G90 G01 R50 Q30 Y10 F100");
    expect_end(b, 50 * std::cos(std::numbers::pi / 6), 25);
    EXPECT_EQ(b.last_move().others[Axis::Y], 10);
}

TEST(IsoMotion, AngleAndOneCoordinate) {
    // The drawing of 8055 T 3.6.3: Q149 from (Z160, Xr30) to Z110 ends at Xr 60.0430.
    IsoRig b;
    b.run("G152\nG18 G90 G01 X30 Z160 F100\nQ149 Z110");
    EXPECT_NEAR(b.last<Line>().end.u, 110, 1e-12);
    EXPECT_NEAR(b.last<Line>().end.v, 60.0430, 5e-5);
    b.run("Q90 X70");
    expect_end(b, 110, 70);
    b.run("G151\nQ135 X160");  // X80 radius: 10 up, 10 left
    expect_end(b, 100, 80);
    b.run("G91 Q180 Z-30");
    expect_end(b, 70, 80);
    EXPECT_TRUE(b.warnings().empty());
    b.run("Q180 Z30");
    EXPECT_EQ(b.warnings(), std::vector<std::string>{"point_behind"});
}

TEST(IsoMotion, AngleErrors) {
    EXPECT_EQ(alarm_of("G18 G152 G90 G01 X0 Z0 F100\nQ90 Z10"), "1076");
    EXPECT_EQ(alarm_of("G18 G152 G90 G01 X0 Z0 F100\nQ0 X10"), "1076");
    EXPECT_EQ(alarm_of("G18 G90 G01 Q30 Q40 F100"), "0173");
}

TEST(IsoMotion, WordsAndParameters) {
    IsoRig b;
    *b.session.parameters.find(3) = 20;
    b.run("G90 G01 X-P3 ZP3 F100");
    expect_end(b, 20, -10);
    b.run("X Z1");
    expect_end(b, 1, 0);
    EXPECT_EQ(b.warnings(), std::vector<std::string>{"number_left_out"});
    EXPECT_EQ(IsoRig().run("G00 XP99").alarm(), "1052");
}

TEST(IsoMotion, NumberFormats) {
    EXPECT_EQ(alarm_of("G00 X99999.9999"), "");
    EXPECT_EQ(alarm_of("G00 X123456.7"), "0147");
    EXPECT_EQ(alarm_of("G00 X10\nG03 X20 I123456 K0 F1"), "0043");  // 6 digits are well for a centre
    EXPECT_EQ(alarm_of("G00 X10\nG03 X20 Z5 I1234567 K0 F1"), "0147");
    IsoRig b;
    *b.session.parameters.find(0) = -2e5;
    EXPECT_EQ(b.run("G00 ZP0").alarm(), "0147");
}

TEST(IsoMotion, AFifthDecimalIsRoundedWithAWarningAtEachWord) {
    IsoRig b;
    b.run("G152\nG00 X10.00016 Z1.23456");
    expect_end(b, 1.2346, 10.0002);
    EXPECT_EQ(b.warnings(), (std::vector<std::string>{"decimals_rounded", "decimals_rounded"}));
}

TEST(IsoMotion, UnknownValuesBlock) {
    IsoRig b;
    *b.session.parameters.find(1) = unknown_value;
    b.run("G00 X10\nG00 XP1");
    EXPECT_TRUE(b.session.blocked);
    EXPECT_FALSE(b.session.failed);
    EXPECT_EQ(b.moves().size(), 1u);
}

TEST(IsoMotion, MissingAxis) {
    auto lathe = built_in_lathe();
    lathe.axes[Axis::V].exists = false;
    EXPECT_EQ(IsoRig(lathe).run("G90 G01 V10 F100").alarm(), "0046");
    EXPECT_EQ(IsoRig(lathe).run("G92 V10").alarm(), "0046");
    EXPECT_EQ(IsoRig(lathe).run("G18 G02 X10 V10 R5 F100").alarm(), "0046");
}

TEST(IsoMotion, NormalRotaryAxisTurnsInTheSenseOfItsSign) {
    IsoRig b;
    const auto c = [&] { return b.last_move().others[Axis::C]; };
    b.run("G90 G01 C90 F500");
    EXPECT_EQ(c(), 90);
    b.run("C-90");  // to the same place: no turn
    EXPECT_EQ(c(), 90);
    b.run("C-80");
    EXPECT_EQ(c(), 80);
    b.run("C70");  // positive: on through 360
    EXPECT_EQ(c(), 430);
    b.run("C-350");
    EXPECT_EQ(c(), 350);
    b.run("G91 C-725");  // increments may be more than a turn
    EXPECT_EQ(c(), -375);
    EXPECT_EQ(alarm_of("G90 G01 C400 F100"), "0168");
    EXPECT_EQ(alarm_of("G91 G01 C400 F100"), "");
}

TEST(IsoMotion, NoTurnByRoundingOfAnAngle) {
    IsoRig b;
    b.run("G91 G01 C0.1 F100\nC0.1\nC0.1\nG90 C0.3");  // 0.1 + 0.1 + 0.1 is a little above 0.3
    EXPECT_NEAR(b.last_move().others[Axis::C], 0.3, 1e-9);
}

TEST(IsoMotion, PositioningAxisGoesTheShortestWay) {
    IsoRig b;
    b.run("G90 G00 A350");
    EXPECT_EQ(b.last_move().others[Axis::A], -10);
    b.run("A20");
    EXPECT_EQ(b.last_move().others[Axis::A], 20);
    b.run("B45");
    EXPECT_EQ(b.last_move().others[Axis::B], 45);
    EXPECT_EQ(alarm_of("G90 G00 A400"), "0167");
    EXPECT_EQ(alarm_of("G90 G00 A-10"), "0167");
    EXPECT_EQ(alarm_of("G90 G00 B45.5"), "0059");
    EXPECT_EQ(alarm_of("G91 G00 B0.5"), "0059");
}

TEST(IsoMotion, RulesOfSeveralPositioningAxes) {
    auto lathe = built_in_lathe();
    lathe.axes[Axis::C].type = machine::AxisType::hirth;
    EXPECT_EQ(IsoRig(lathe).run("G90 G00 B10 C10").alarm(), "0166");
    EXPECT_EQ(alarm_of("G90 G01 A10 B10 F100"), "0201");
    EXPECT_EQ(alarm_of("G90 G00 A10 B10"), "");
}

TEST(IsoMotion, RotaryAxisWithoutRolloverIsLikeALinearOne) {
    auto lathe = built_in_lathe();
    lathe.axes[Axis::C].rollover = false;
    IsoRig b(lathe);
    b.run("G90 G01 C-400 F100");
    EXPECT_EQ(b.last_move().others[Axis::C], -400);
    lathe.axes[Axis::C].type = machine::AxisType::hirth;
    EXPECT_EQ(IsoRig(lathe).run("G00 C0.5").alarm(), "0059");
}

TEST(IsoMotion, ThreadOfTheManual) {
    IsoRig b;
    b.run("S500 M3\nG90 G00 X116 Z180\nG33 Z40 L5");
    EXPECT_EQ(b.last<Thread>().end, (Point{40, 58}));
    EXPECT_EQ(b.last<Thread>().lead, 5);
    EXPECT_EQ(b.last<Thread>().angle, 0);
    b.run("X140 Z30 L2.5 Q-180");  // G33 is modal
    EXPECT_EQ(b.last<Thread>().end, (Point{30, 70}));
    EXPECT_EQ(b.last<Thread>().lead, 2.5);
    EXPECT_EQ(b.last<Thread>().angle, -180);
}

TEST(IsoMotion, LeadOfATaperByPolicy) {
    // 8055 T 6.12: from (Xr42, Z190) to (Xr70, Z50), 142.7725 long: 28.5552 turns along the path, 28 along Z.
    const std::string_view blocks = "S500 M3\nG90 G00 X84 Z190\nG33 X140 Z50 L5";
    IsoRig path;
    path.run(blocks);
    EXPECT_EQ(path.last<Thread>().lead, 5);
    auto lathe = built_in_lathe();
    lathe.policy.thread_lead = machine::Policies::ThreadLead::major_axis;
    IsoRig axis(lathe);
    axis.run(blocks);
    EXPECT_NEAR(142.7725 / axis.last<Thread>().lead, 28, 1e-5);
}

TEST(IsoMotion, ThreadErrors) {
    EXPECT_EQ(alarm_of("S500 M3\nG33 Z-20"), "0053");
    EXPECT_EQ(alarm_of("S500 M3\nG33 Z-20 L2\nZ-30"), "0053");
    EXPECT_EQ(alarm_of("S500 M3\nG33 Z-20 L2 Q400"), "0227");
    EXPECT_EQ(alarm_of("G33 Z-20 L2"), "1036");
    EXPECT_EQ(alarm_of("G51 E0.05\nS500 M3\nG33 Z-20 L2"), "0007");
    auto lathe = built_in_lathe();
    lathe.m19_type = 0;
    EXPECT_EQ(IsoRig(lathe).run("S500 M3\nG33 Z-20 L2 Q90").alarm(), "0228");
    EXPECT_EQ(IsoRig(lathe).run("S500 M3\nG33 Z-20 L2").alarm(), "");
}

}  // namespace
}  // namespace fagorc::passes::testing
