// The functions in degrees: the values by heart exactly, all others against libm in long double.
#include "passes/execute/trigonometry.hpp"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

namespace fagorc::passes::trigonometry {
namespace {

constexpr double half_root_3 = 0.86602540378443864676;

TEST(Trigonometry, SineAndCosineAreExactAtMultiplesOf30) {
    const double sines[] = {0, 0.5, half_root_3, 1, half_root_3, 0.5, 0, -0.5, -half_root_3, -1, -half_root_3, -0.5};
    for (int turn = -3; turn <= 3; ++turn)
        for (int k = 0; k < 12; ++k) {
            EXPECT_EQ(sine(360.0 * turn + 30 * k), sines[k]) << 360 * turn + 30 * k;
            EXPECT_EQ(cosine(360.0 * turn + 30 * k), sines[(k + 3) % 12]) << 360 * turn + 30 * k;
        }
    EXPECT_FALSE(std::signbit(sine(180)));
}

TEST(Trigonometry, OtherAnglesAgreeWithLongDouble) {
    constexpr long double rad = std::numbers::pi_v<long double> / 180;
    for (double a = -725.3; a < 725; a += 0.71) {
        EXPECT_NEAR(sine(a), static_cast<double>(std::sin(a * rad)), 2e-16);
        EXPECT_NEAR(cosine(a), static_cast<double>(std::cos(a * rad)), 2e-16);
    }
    // 3600000.25 is 10000 turns and a quarter of a degree.
    EXPECT_EQ(sine(3600000.25), sine(0.25));
}

TEST(Trigonometry, TangentIsOneAt45AndInfiniteAt90) {
    EXPECT_EQ(tangent(45), 1);
    EXPECT_EQ(tangent(135), -1);
    EXPECT_EQ(tangent(-45), -1);
    EXPECT_EQ(tangent(225), 1);
    EXPECT_TRUE(std::isinf(tangent(90)));
    EXPECT_TRUE(std::isinf(tangent(-90)));
    EXPECT_NEAR(tangent(30), 0.57735026918962576451, 2e-16);
    EXPECT_NEAR(tangent(120), -1.7320508075688772935, 4e-16);
}

TEST(Trigonometry, ArcFunctionsGiveTheKnownAngles) {
    EXPECT_EQ(arc_sine(1), 90);      // 8055 T 11.4
    EXPECT_EQ(arc_cosine(1), 0);     // 8055 T 11.4
    EXPECT_EQ(arc_tangent(1), 45);   // 8055 T 11.4
    EXPECT_EQ(arc_sine(0.5), 30);
    EXPECT_EQ(arc_cosine(0.5), 60);
    EXPECT_EQ(arc_cosine(-1), 180);
    EXPECT_EQ(arc_sine(-0.5), -30);
    // x + x^3/6 + 3x^5/40 + 15x^7/336 = 0.123312275 rad
    EXPECT_NEAR(arc_sine(0.123), 7.0652729, 1e-6);
}

TEST(Trigonometry, AngleOfAPointIsFrom0To360) {
    EXPECT_NEAR(of_point(-1, -2), 243.43494882292201, 1e-12);   // 8055 T 11.4: ARG(-1,-2) = 243.4349
    EXPECT_EQ(of_point(5, 0), 0);
    EXPECT_EQ(of_point(0, 3), 90);
    EXPECT_EQ(of_point(-5, 0), 180);
    EXPECT_EQ(of_point(0, -3), 270);
    EXPECT_EQ(of_point(2, 2), 45);
    EXPECT_EQ(of_point(2, -2), 315);
}

}  // namespace
}  // namespace fagorc::passes::trigonometry
