// The trigonometric functions of the language: degrees, exact where a programmer knows the value by heart, so that
// SIN 30 compares equal to 0.5 (8055 T 11.4).
#pragma once

namespace fagorc::passes::trigonometry {

double sine(double angle);
double cosine(double angle);
/// Infinite at odd multiples of 90.
double tangent(double angle);

/// -90 .. 90; the argument within -1 .. 1.
double arc_sine(double value);
/// 0 .. 180; the argument within -1 .. 1.
double arc_cosine(double value);
/// -90 .. 90.
double arc_tangent(double value);
/// Angle of the point (x, y), 0 .. 360 exclusive; not for the origin.
double of_point(double x, double y);

}  // namespace fagorc::passes::trigonometry
