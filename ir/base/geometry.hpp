// The plane geometry kernel: points and vectors of the active plane. Millimetres; X as a radius.
#pragma once

#include <cmath>
#include <numbers>

namespace fagorc {

/// A point or vector of the active plane (u abscissa, v ordinate), millimetres, X as a radius.
struct Point {
    double u = 0;
    double v = 0;
    friend constexpr bool operator==(Point, Point) = default;
};

constexpr Point operator+(Point a, Point b) { return {a.u + b.u, a.v + b.v}; }
constexpr Point operator-(Point a, Point b) { return {a.u - b.u, a.v - b.v}; }
constexpr Point operator*(double k, Point a) { return {k * a.u, k * a.v}; }
constexpr double dot(Point a, Point b) { return a.u * b.u + a.v * b.v; }
/// Positive when b lies to the left of a.
constexpr double cross(Point a, Point b) { return a.u * b.v - a.v * b.u; }
/// The vector turned by +90 degrees: the left side of a path that runs along it.
constexpr Point left(Point a) { return {-a.v, a.u}; }
/// Coordinates stay far below the square root of the largest double, so nothing overflows (and this is a third of hypot).
inline double length(Point a) { return std::sqrt(dot(a, a)); }
inline double distance(Point a, Point b) { return length(b - a); }

constexpr double radians(double degrees) { return degrees * (std::numbers::pi / 180.0); }
constexpr double degrees(double radians) { return radians * (180.0 / std::numbers::pi); }

/// cos and sin of an angle in degrees, exact at multiples of 90 (a quarter circle ends on its axis).
inline Point direction(double angle_in_degrees) {
    const double a = std::remainder(angle_in_degrees, 360.0);
    if (a == 0) return {1, 0};
    if (a == 90) return {0, 1};
    if (a == -90) return {0, -1};
    if (a == 180 || a == -180) return {-1, 0};
    return {std::cos(radians(a)), std::sin(radians(a))};
}

/// Smallest difference that geometry tells apart, mm: below it two points are one (8055 T 6.3: words have 0.0001 mm).
inline constexpr double point_tolerance = 1e-9;
/// A chord up to this long closes a full circle, mm: half a unit of the words' last decimal (8055 T 6.3).
inline constexpr double full_circle_chord = 0.0005;

/// The angle swept by an arc from `start` to `end` about `centre`, radians, in (0, 2 pi]; `full` means a whole turn.
inline double swept_angle(Point start, Point end, Point centre, bool ccw, bool full) {
    if (full) return 2 * std::numbers::pi;
    const Point a = start - centre, b = end - centre;
    double angle = std::atan2(cross(a, b), dot(a, b));
    if (!ccw) angle = -angle;
    return angle <= 0 ? angle + 2 * std::numbers::pi : angle;
}

}  // namespace fagorc
