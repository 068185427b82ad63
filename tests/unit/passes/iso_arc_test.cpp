// Arcs and helices (8055 T 6.3 to 6.7): each form against the circle that it names. X as a radius in all results.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/passes/iso_rig.hpp"

namespace fagorc::passes::testing {
namespace {

using operation::Arc;
using operation::Line;

void expect_point(Point p, double u, double v, double tolerance = 1e-9) {
    EXPECT_NEAR(p.u, u, tolerance);
    EXPECT_NEAR(p.v, v, tolerance);
}

std::string alarm_of(std::string_view blocks) {
    return IsoRig().run(blocks).alarm();
}

TEST(IsoArc, CentreIsARadiusUnderDiameters) {
    IsoRig b;
    b.run("G18 G151 G90 G00 X80 Z60\nG03 X180 Z110 I50 K0 F100");
    expect_point(b.last<Arc>().end, 110, 90);
    expect_point(b.last<Arc>().centre, 60, 90);
    EXPECT_TRUE(b.last<Arc>().ccw);
    EXPECT_FALSE(b.last<Arc>().full);
    b.run("X80 Z160 K50");  // G03 is modal, I left out is 0
    expect_point(b.last<Arc>().end, 160, 40);
    expect_point(b.last<Arc>().centre, 160, 90);
}

TEST(IsoArc, ClockwiseAndIncremental) {
    IsoRig b;
    b.run("G18 G152 G90 G00 X10 Z50\nG91 G02 X20 Z-20 I20 K0 F100");
    expect_point(b.last<Arc>().end, 30, 30);
    expect_point(b.last<Arc>().centre, 50, 30);
    EXPECT_FALSE(b.last<Arc>().ccw);
}

TEST(IsoArc, RadiusForm) {
    IsoRig b;
    b.run("G18 G152 G90 G00 X40 Z60\nG03 X90 Z110 R50 F100");
    expect_point(b.last<Arc>().centre, 60, 90);
    b.run("G00 X40 Z60\nG03 X90 Z110 R-50");  // above 180 degrees: the other centre
    expect_point(b.last<Arc>().centre, 110, 40);
    b.run("G00 X40 Z60\nG02 X90 Z110 R50");
    expect_point(b.last<Arc>().centre, 110, 40);
    EXPECT_EQ(alarm_of("G18 G152 G90 G00 X10 Z50\nG02 X10 Z50 R20 F100"), "1077");
    EXPECT_EQ(alarm_of("G18 G152 G90 G00 X10 Z50\nG02 X50 Z50 R19.9 F100"), "1077");
    EXPECT_EQ(alarm_of("G18 G152 G90 G00 X10 Z50\nG02 X50 Z50 R19.995 F100"), "");
}

TEST(IsoArc, PolarFormAboutCentreOrOrigin) {
    IsoRig b;
    b.run("G18 G152 G90 G00 X40 Z60\nG03 Q0 I50 K0 F100");
    expect_point(b.last<Arc>().end, 110, 90);
    expect_point(b.last<Arc>().centre, 60, 90);
    b.run("G00 X40 Z130\nG93 I130 J0\nG02 Q0");
    expect_point(b.last<Arc>().end, 170, 0);
    expect_point(b.last<Arc>().centre, 130, 0);
    b.run("G91 G03 Q90");  // from the start angle 0
    expect_point(b.last<Arc>().end, 130, 40);
    b.run("Q-360");
    EXPECT_TRUE(b.last<Arc>().full);
    expect_point(b.last<Arc>().end, 130, 40);
    EXPECT_EQ(alarm_of("G18 G90 G00 X40 Z130\nG02 Q0 X10 F100"), "0044");
}

TEST(IsoArc, FullCircles) {
    IsoRig b;
    b.run("G152\nG18 G90 G00 X50 Z50\nG03 X50 Z50 I0 K20 F100");
    EXPECT_TRUE(b.last<Arc>().full);
    expect_point(b.last<Arc>().end, 50, 50);
    expect_point(b.last<Arc>().centre, 70, 50);
    EXPECT_TRUE(b.warnings().empty());
    b.run("I10");  // no end point: full circle, with a warning
    EXPECT_TRUE(b.last<Arc>().full);
    EXPECT_EQ(b.warnings(), std::vector<std::string>{"full_circle_without_end"});
    b.run("X50.0004 Z50 K20");  // a chord of 0.0004 closes too and ends in the start
    EXPECT_TRUE(b.last<Arc>().full);
    EXPECT_EQ(b.last<Arc>().end, (Point{50, 50}));
}

TEST(IsoArc, CheckOfTheRadii) {
    const std::string start = "G18 G152 G90 G00 X40 Z60\n";
    EXPECT_EQ(alarm_of(start + "G03 X90 Z110 I40 K0 F100"), "1084");
    EXPECT_EQ(alarm_of(start + "G03 X90.011 Z110 I50 K0 F100"), "");  // 0.011 along the tangent
    EXPECT_EQ(alarm_of(start + "G03 X90 Z110.011 I50 K0 F100"), "1084");
    EXPECT_EQ(alarm_of(start + "G03 X90 Z110 I0 K0 F100"), "1087");
    EXPECT_EQ(alarm_of(start + "G03 X90 F100"), "0043");
    EXPECT_EQ(alarm_of(start + "G03 X90 Z110 F100"), "0043");
    EXPECT_EQ(alarm_of(start + "G03 X90 Y10 R50 F100"), "0049");
    EXPECT_EQ(alarm_of(start + "G03 X90 Z110 A5 R50 F100"), "0055");
    IsoRig b;
    b.run(start + "G03 X90 Z110.004 I50 K0 F100");
    const auto& arc = b.last<Arc>();
    EXPECT_EQ(arc.end, (Point{110.004, 90}));
    EXPECT_NEAR(distance(arc.centre, {60, 40}), distance(arc.centre, arc.end), 1e-12);
    auto lathe = built_in_lathe();
    lathe.arc_tolerance = 0.001;
    EXPECT_EQ(IsoRig(lathe).run(start + "G03 X90 Z110.004 I50 K0 F100").alarm(), "1084");
}

TEST(IsoArc, AbsoluteCentre) {
    IsoRig b;
    b.run("G18 G151 G90 G00 X80 Z60\nG06 G03 X180 Z110 I180 K60 F100");  // I as an X word: a diameter
    expect_point(b.last<Arc>().centre, 60, 90);
    b.run("G152\nG00 X40 Z60\nG06 G03 Q0 I90 K60");
    expect_point(b.last<Arc>().end, 110, 90);
    b.run("G91 G06 G02 X-50 Z-50 I90 K60");  // still absolute
    expect_point(b.last<Arc>().end, 60, 40);
    expect_point(b.last<Arc>().centre, 60, 90);
    EXPECT_TRUE(b.warnings().empty());
    b.run("G90 G06 X-40 Z60 K60");  // I left out is the coordinate 0
    expect_point(b.last<Arc>().centre, 60, 0);
    EXPECT_EQ(b.warnings(), std::vector<std::string>{"centre_coordinate_missing"});
    EXPECT_EQ(alarm_of("G18 G90 G00 X80 Z60\nG06 G03 X180 Z110 R50 F100"), "0052");
}

TEST(IsoArc, TangentChainOfTheManual) {
    // 8055 T 6.5: senses G03, G02, G03; the modal motion stays G01.
    IsoRig b;
    b.run("G18 G152 G90 G01 X0 Z270 F100\nX50 Z250\nG08 X60 Z180");
    expect_point(b.last<Arc>().centre, 212.1212, 34.8485, 5e-5);
    EXPECT_TRUE(b.last<Arc>().ccw);
    b.run("G08 X50 Z130");
    expect_point(b.last<Arc>().centre, 149.1723, 84.1387, 5e-5);
    EXPECT_FALSE(b.last<Arc>().ccw);
    b.run("G08 X60 Z100");
    expect_point(b.last<Arc>().centre, 88.9952, -23.0144, 5e-5);
    EXPECT_TRUE(b.last<Arc>().ccw);
    b.run("X60 Z40");
    EXPECT_EQ(b.last<Line>().end, (Point{40, 60}));
}

TEST(IsoArc, TangentArcByPolarEnd) {
    IsoRig b;
    b.run("G18 G152 G90 G01 X0 Z0 F100\nZ10\nG08 R20 Q90");  // to (0, 20): |d|^2 / 2q = 500 / 40
    expect_point(b.last<Arc>().end, 0, 20);
    expect_point(b.last<Arc>().centre, 10, 12.5);
}

TEST(IsoArc, TangentArcErrors) {
    EXPECT_EQ(alarm_of("G18 G152 G90 G01 X0 Z0 F100\nZ10\nG08 X0 Z30"), "1007");
    EXPECT_EQ(alarm_of("G08 X10 Z10 F100"), "1008");
    EXPECT_EQ(alarm_of("G18 G90 G01 X10 Z10 F100\nG17\nG08 X20 Y20"), "1010");
    std::string waits = "G18 G90 G01 X10 Z10 F100\n";
    for (int i = 0; i < 48; ++i) waits += "G04 K1\n";
    EXPECT_EQ(alarm_of(waits + "G08 X20 Z30"), "");
    EXPECT_EQ(alarm_of(waits + "G04 K1\nG08 X20 Z30"), "1008");
}

TEST(IsoArc, ThreePoints) {
    IsoRig b;
    b.run("G18 G151 G90 G00 X60 Z70\nG09 X120 Z20 I60 K50 F100");  // I is a diameter here
    expect_point(b.last<Arc>().centre, 60, 70);
    EXPECT_FALSE(b.last<Arc>().ccw);
    b.run("G152 G00 X30 Z70\nG91 G09 X30 Z-50 I0 K-20");  // relative to the start
    expect_point(b.last<Arc>().centre, 60, 70);
    b.run("G90 G00 X30 Z70\nG09 R63.2456 Q71.5651 I30 K50");  // polar end (20, 60)
    expect_point(b.last<Arc>().centre, 60, 70, 1e-3);
    EXPECT_EQ(alarm_of("G18 G152 G90 G00 X10 Z10\nG09 X30 Z30 I20 K20 F100"), "1084");
    EXPECT_EQ(alarm_of("G18 G152 G90 G00 X10 Z10\nG09 X30 Z30 I10 K10 F100"), "1084");
    EXPECT_EQ(alarm_of("G18 G152 G90 G00 X10 Z10\nG09 X30 Z30 I10 K20 L5 F100"), "0044");
}

TEST(IsoArc, ThreePointsNeedTheLettersOfThePlane) {
    const std::string start = "G18 G152\nG90 G00 X40 Z5\n";
    // J is a letter of another plane: what G02 says about it.
    EXPECT_EQ(alarm_of(start + "G09 X60 Z-5 I55 J2 F100"), "0052");
    EXPECT_EQ(alarm_of(start + "G02 X60 Z-5 I10 J1 F100"), "0052");
    EXPECT_EQ(alarm_of(start + "G02 X60 Z-5 R20 J1 F100"), "0052");
    EXPECT_EQ(alarm_of(start + "G09 X60 Z-5 F100"), "operands_wrong");
    // One letter left out is 0, and named: the circle through (Z5 X40), (Z0 X55), (Z-5 X60).
    IsoRig b;
    b.run(start + "G09 X60 Z-5 I55 F100");
    ASSERT_EQ(b.warnings(), std::vector<std::string>{"centre_coordinate_missing"});
    EXPECT_EQ(b.findings.list().front().arguments.front().plain, "K");
    // They are 25 from (-20, 40): (25, 0), (20, 15), (15, 20).
    expect_point(b.last<Arc>().centre, -20.0, 40.0);
}

TEST(IsoArc, ItsOwnErrorComesBeforeTheFeed) {
    IsoRig b;
    b.run("G18 G152\nG90 G00 X40 Z5\nG03 X40 I");
    EXPECT_EQ(b.alarm(), "0043");                                          // the coordinate of Z is missing
    EXPECT_EQ(b.warnings(), std::vector<std::string>{"number_left_out"});  // and not feed_is_highest
}

TEST(IsoArc, PolarOriginFollowsArcsByParameter) {
    const std::string_view blocks = "G18 G152 G90 G00 X40 Z60\nG03 X90 Z110 I50 K0 F100\nG01 R10 Q0";
    IsoRig stays;
    stays.run(blocks);
    EXPECT_EQ(stays.last<Line>().end, (Point{10, 0}));
    auto lathe = built_in_lathe();
    lathe.polar_origin_follows_arcs = true;
    IsoRig follows(lathe);
    follows.run(blocks);
    expect_point(follows.last<Line>().end, 70, 90);
}

TEST(IsoArc, HelixInProportion) {
    IsoRig b;
    b.run("G19 G90 G152 G00 X0 Y0 Z20\nG02 X30 Y0 Z20 J0 K-20 F100");
    EXPECT_TRUE(b.last<Arc>().full);
    EXPECT_EQ(b.last_move().others[Axis::X], 30);
    EXPECT_TRUE(b.last_move().moved.has(Axis::X));
    b.run("G18 G00 X10 Y0 Z0\nG03 X0 Y5 Z-10 I-10 K0");
    EXPECT_EQ(b.last_move().others[Axis::Y], 5);
}

TEST(IsoArc, HelixOfSeveralTurns) {
    IsoRig b;
    b.run("G19 G90 G152 G00 X0 Y0 Z20\nG02 X-20 Y0 Z20 J0 K-20 I5 F100");
    const auto moves = b.moves();
    ASSERT_EQ(moves.size(), 5u);  // the rapid and four turns
    for (std::size_t i = 1; i < 5; ++i) {
        EXPECT_TRUE(std::get<Arc>(moves[i].what).full);
        EXPECT_NEAR(moves[i].others[Axis::X], -5.0 * static_cast<double>(i), 1e-12);
    }
    b.run("G00 X0\nG02 X11.25 Y20 Z0 J0 K-20 I5");  // two turns and the quarter from (0,20) to (20,0)
    EXPECT_EQ(b.moves().size(), 9u);
    EXPECT_FALSE(b.last<Arc>().full);
    EXPECT_EQ(b.last_move().others[Axis::X], 11.25);
    EXPECT_EQ(alarm_of("G19 G90 G152 G00 X0 Y0 Z20\nG02 X21 Y0 Z20 J0 K-20 I5 F100"), "1085");
    EXPECT_EQ(alarm_of("G19 G90 G152 G00 X0 Y0 Z20\nG02 X20 Y0 Z20 J0 K-20 I-5 F100"), "0054");
}

TEST(IsoArc, OneLetterForBothAxesOfThePlane) {
    // Plane XU: the first I is X's, the second U's (8055 T 6.3).
    IsoRig b;
    b.run("G16 X U\nG90 G152 G00 X10 U0\nG03 X0 U10 I-10 I0 F100");
    EXPECT_EQ(b.last<Arc>().end, (Point{0, 10}));
    expect_point(b.last<Arc>().centre, 0, 0);
    b.run("G16 U X\nG02 X10 U0 I0 I-10");  // still X's first; u is U now
    EXPECT_EQ(b.last<Arc>().end, (Point{0, 10}));
    expect_point(b.last<Arc>().centre, 0, 0);
}

}  // namespace
}  // namespace fagorc::passes::testing
