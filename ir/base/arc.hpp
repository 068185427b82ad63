// Circles of the active plane from what a program gives: a radius, a tangent, three points. Pure functions;
// millimetres, X as a radius.
#pragma once

#include <optional>

#include "ir/base/geometry.hpp"

namespace fagorc {

/// Largest radius and distance of a centre that a control computes with, mm (8055 T 6.3).
inline constexpr double largest_radius = 214748.3647;

/// Where an arc turns and which way.
struct Turn {
    Point centre;
    bool ccw = false;
};

/// The point of the perpendicular bisector of start and end that is nearest to `centre`: both ends keep their place and
/// the arc is exact (8055 T 6.3). `start` and `end` differ.
Point onto_bisector(Point start, Point end, Point centre);

/// Centre of the arc from start to end with |radius|: the arc below 180 degrees for a positive radius, above for a
/// negative one (8055 T 6.3). A radius short of half the chord by at most `tolerance` makes a half circle; nothing for
/// a shorter one, and for a chord that closes a full circle.
std::optional<Point> centre_of_radius(Point start, Point end, double radius, bool ccw, double tolerance);

/// The arc from start that leaves in the direction `tangent` (any length but zero) and ends in `end`; nothing where
/// the end lies on the tangent line (8055 T 6.5).
std::optional<Turn> tangent_arc(Point start, Point tangent, Point end);

/// The arc from start over `middle` to end; nothing for points in line or twice the same point (8055 T 6.6).
std::optional<Turn> arc_through(Point start, Point middle, Point end);

/// Direction of the path in the point `at` of an arc; its length is the radius.
constexpr Point arc_direction(Point at, Point centre, bool ccw) {
    const Point l = left(at - centre);
    return ccw ? l : -1.0 * l;
}

}  // namespace fagorc
