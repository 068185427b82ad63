#include "ir/base/arc.hpp"

#include <algorithm>
#include <cmath>

namespace fagorc {
namespace {

/// Sine of the smallest angle between two directions that still differ: an arc that is flatter has a radius beyond
/// any control.
constexpr double flat = 1e-9;

/// The arc that starts in `start` with unit normal `normal` (its left side) and ends in `end`.
std::optional<Turn> with_normal(Point start, Point normal, Point end) {
    const Point chord = end - start;
    const double rise = dot(chord, normal);
    if (std::abs(rise) <= std::max(point_tolerance, flat * length(chord))) return std::nullopt;
    return Turn{start + dot(chord, chord) / (2 * rise) * normal, rise > 0};
}

}  // namespace

Point onto_bisector(Point start, Point end, Point centre) {
    const Point middle = 0.5 * (start + end);
    const Point normal = left(end - start);
    return middle + dot(centre - middle, normal) / dot(normal, normal) * normal;
}

std::optional<Point> centre_of_radius(Point start, Point end, double radius, bool ccw, double tolerance) {
    const double half = distance(start, end) / 2;
    if (2 * half <= full_circle_chord || half - std::abs(radius) > tolerance) return std::nullopt;
    const double height = std::sqrt(std::max(0.0, radius * radius - half * half));
    const bool centre_left = ccw == (radius > 0);
    const Point normal = 1 / (2 * half) * left(end - start);
    return 0.5 * (start + end) + (centre_left ? height : -height) * normal;
}

std::optional<Turn> tangent_arc(Point start, Point tangent, Point end) {
    return with_normal(start, 1 / length(tangent) * left(tangent), end);
}

std::optional<Turn> arc_through(Point start, Point middle, Point end) {
    const Point a = middle - start, b = end - start;
    const double twice_area = cross(a, b);
    if (std::abs(twice_area) <= flat * length(a) * length(b) || distance(middle, end) <= point_tolerance)
        return std::nullopt;
    // The centre is as far from start as from both others: two linear equations (circumcentre).
    const double aa = dot(a, a), bb = dot(b, b);
    const Point to_centre = 1 / (2 * twice_area) * Point{b.v * aa - a.v * bb, a.u * bb - b.u * aa};
    return Turn{start + to_centre, twice_area > 0};
}

}  // namespace fagorc
