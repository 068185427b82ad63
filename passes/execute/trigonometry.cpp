#include "passes/execute/trigonometry.hpp"

#include <cmath>
#include <cstdint>
#include <limits>

#include "ir/base/geometry.hpp"

namespace fagorc::passes::trigonometry {
namespace {

constexpr double half_root_3 = 0.86602540378443864676;
/// Up to here the angle's quarter fits an integer; beyond, libm reduces the angle.
constexpr double largest_reduced = 1e15;

/// An angle as a number of quarter turns and the rest, -45 .. 45. The subtraction is exact: both sides are multiples of
/// the angle's last bit and the result is small.
struct Reduced {
    unsigned quarter = 0;
    double rest = 0;
};

Reduced reduce(double angle) {
    if (!(std::abs(angle) < largest_reduced)) angle = std::fmod(angle, 360.0);
    const auto turns = static_cast<std::int64_t>(angle * (1 / 90.0) + (angle < 0 ? -0.5 : 0.5));
    return {static_cast<unsigned>(turns & 3), angle - 90.0 * static_cast<double>(turns)};
}

double small_sine(double a) {
    if (a == 30) return 0.5;
    if (a == -30) return -0.5;
    return std::sin(radians(a));
}

double small_cosine(double a) {
    return a == 30 || a == -30 ? half_root_3 : std::cos(radians(a));
}

/// The nearest multiple of 15 degrees where its function value is exactly the argument, else the angle itself.
double known_angle(double angle, double value, double (*function)(double)) {
    const double known = 15 * std::round(angle / 15);
    return function(known) == value ? known : angle;
}

}  // namespace

double sine(double angle) {
    if (std::isnan(angle)) return angle;
    const Reduced r = reduce(angle);
    const double s = r.quarter & 1 ? small_cosine(r.rest) : small_sine(r.rest);
    return r.quarter & 2 ? 0.0 - s : s;  // 0 - 0 is 0: no negative zero
}

double cosine(double angle) {
    if (std::isnan(angle)) return angle;
    const Reduced r = reduce(angle);
    const double c = r.quarter & 1 ? small_sine(r.rest) : small_cosine(r.rest);
    return r.quarter == 1 || r.quarter == 2 ? 0.0 - c : c;
}

double tangent(double angle) {
    if (std::isnan(angle)) return angle;
    const Reduced r = reduce(angle);
    if (r.rest == 45) return r.quarter & 1 ? -1 : 1;
    if (r.rest == -45) return r.quarter & 1 ? 1 : -1;
    const double s = small_sine(r.rest), c = small_cosine(r.rest);
    if (!(r.quarter & 1)) return s / c;
    return s == 0 ? std::numeric_limits<double>::infinity() : 0.0 - c / s;
}

double arc_sine(double value) {
    return known_angle(degrees(std::asin(value)), value, sine);
}
double arc_cosine(double value) {
    return known_angle(degrees(std::acos(value)), value, cosine);
}
double arc_tangent(double value) {
    return known_angle(degrees(std::atan(value)), value, tangent);
}

double of_point(double x, double y) {
    if (y == 0) return x < 0 ? 180 : 0;
    if (x == 0) return y < 0 ? 270 : 90;
    const double first = arc_tangent(std::abs(y / x));
    if (x > 0) return y > 0 ? first : 360 - first;
    return y > 0 ? 180 - first : 180 + first;
}

}  // namespace fagorc::passes::trigonometry
