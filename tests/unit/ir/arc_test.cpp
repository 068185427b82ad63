// Circle geometry against formulas of its own: distances and angles of the results, and drawings of the manual.
#include "ir/base/arc.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace fagorc {
namespace {

constexpr double near = 1e-9;

TEST(Arc, RadiusFormPicksTheSideBySenseAndSign) {
    // Quarter circles of radius 20 from (50,10) to (30,30): the centres are the two other corners of the square.
    const Point start{50, 10}, end{30, 30};
    const Point outer{50, 30}, inner{30, 10};
    for (bool ccw : {false, true})
        for (double sign : {1.0, -1.0}) {
            const auto centre = centre_of_radius(start, end, sign * 20, ccw, 0.01);
            ASSERT_TRUE(centre);
            EXPECT_NEAR(distance(*centre, start), 20, near);
            EXPECT_NEAR(distance(*centre, end), 20, near);
            const double turn = swept_angle(start, end, *centre, ccw, false);
            EXPECT_NEAR(turn, sign > 0 ? std::numbers::pi / 2 : 3 * std::numbers::pi / 2, near);
        }
    EXPECT_NEAR(distance(*centre_of_radius(start, end, 20, true, 0.01), inner), 0, near);
    EXPECT_NEAR(distance(*centre_of_radius(start, end, 20, false, 0.01), outer), 0, near);
}

TEST(Arc, RadiusFormRefusesFullCircleAndShortRadius) {
    EXPECT_FALSE(centre_of_radius({50, 10}, {50, 10}, 20, true, 0.01));
    EXPECT_FALSE(centre_of_radius({0, 0}, {20, 0}, 9.98, true, 0.01));
    const auto half = centre_of_radius({0, 0}, {20, 0}, 9.995, true, 0.01);  // short by less than CIRINERR
    ASSERT_TRUE(half);
    EXPECT_EQ(*half, (Point{10, 0}));
}

TEST(Arc, CorrectedCentreIsEquallyFarFromBothEnds) {
    const Point start{60, 40}, end{110, 90.004}, centre{60, 90};
    const Point exact = onto_bisector(start, end, centre);
    EXPECT_NEAR(distance(exact, start), distance(exact, end), near);
    EXPECT_LT(distance(exact, centre), 0.004);
    // Nothing nearer does: the correction runs along the chord.
    EXPECT_NEAR(cross(exact - centre, end - start), 0, 1e-6);
}

TEST(Arc, TangentArcOfTheManual) {
    // 8055 T 6.5: line (270,0)-(250,50), then G08 to (180,60): centre (212.1212, 34.8485), radius 40.7967, G03.
    const auto arc = tangent_arc({250, 50}, {-20, 50}, {180, 60});
    ASSERT_TRUE(arc);
    EXPECT_NEAR(arc->centre.u, 212.1212, 5e-5);
    EXPECT_NEAR(arc->centre.v, 34.8485, 5e-5);
    EXPECT_TRUE(arc->ccw);
    EXPECT_NEAR(distance(arc->centre, {250, 50}), 40.7967, 5e-5);
    EXPECT_NEAR(distance(arc->centre, {180, 60}), 40.7967, 5e-5);
    EXPECT_NEAR(cross(arc_direction({250, 50}, arc->centre, true), {-20, 50}), 0, 1e-6);
    // and on from there, tangent to the arc: G02 about (149.1723, 84.1387).
    const auto next = tangent_arc({180, 60}, arc_direction({180, 60}, arc->centre, arc->ccw), {130, 50});
    ASSERT_TRUE(next);
    EXPECT_NEAR(next->centre.u, 149.1723, 5e-5);
    EXPECT_NEAR(next->centre.v, 84.1387, 5e-5);
    EXPECT_FALSE(next->ccw);
}

TEST(Arc, NoTangentArcToAPointOfTheTangent) {
    EXPECT_FALSE(tangent_arc({10, 0}, {1, 0}, {30, 0}));
    EXPECT_FALSE(tangent_arc({10, 0}, {1, 0}, {10, 0}));
}

TEST(Arc, ThreePointsOfTheManual) {
    // 8055 T 6.6: (70,30) over (50,30) to (20,60): centre (60,70), radius 41.2311, G02.
    const auto arc = arc_through({70, 30}, {50, 30}, {20, 60});
    ASSERT_TRUE(arc);
    EXPECT_NEAR(arc->centre.u, 60, near);
    EXPECT_NEAR(arc->centre.v, 70, near);
    EXPECT_FALSE(arc->ccw);
}

TEST(Arc, ThreePointsInLineOrRepeated) {
    EXPECT_FALSE(arc_through({10, 10}, {20, 20}, {30, 30}));
    EXPECT_FALSE(arc_through({10, 10}, {10, 10}, {30, 30}));
    EXPECT_FALSE(arc_through({10, 10}, {30, 30}, {30, 30}));
    EXPECT_FALSE(arc_through({10, 10}, {30, 30}, {10, 10}));
}

TEST(Geometry, DirectionsOnTheAxesAreExact) {
    EXPECT_EQ(direction(90), (Point{0, 1}));
    EXPECT_EQ(direction(-270), (Point{0, 1}));
    EXPECT_EQ(direction(540), (Point{-1, 0}));
    EXPECT_NEAR(direction(30).v, 0.5, near);
}

TEST(Geometry, SweptAngleTellsSenseAndFullTurn) {
    EXPECT_NEAR(swept_angle({1, 0}, {0, 1}, {0, 0}, true, false), std::numbers::pi / 2, near);
    EXPECT_NEAR(swept_angle({1, 0}, {0, 1}, {0, 0}, false, false), 3 * std::numbers::pi / 2, near);
    EXPECT_NEAR(swept_angle({1, 0}, {1, 0}, {0, 0}, true, true), 2 * std::numbers::pi, near);
}

}  // namespace
}  // namespace fagorc
