// Operands that many constructs of the 8055 T share.
#pragma once

#include "ir/control/operand.hpp"

namespace fagorc::frontend::fagor8055 {

using control::Need;
using control::Operand;
using control::Range;
using control::Role;

inline constexpr Range positive{.least = 0, .above = true};
inline constexpr Range not_negative{.least = 0};

/// Words of a motion (8055 T 3.6).
inline constexpr Operand end_point{
    control::any_axis, Role::coordinate, Need::optional, {}, {}, {"end point", "point d'arrivée", "punto final"}};
inline constexpr Operand polar_radius{
    'R',
    Role::length,
    Need::optional,
    {},
    {},
    {"polar radius of the end point", "rayon polaire du point d'arrivée", "radio polar del punto final"}};
inline constexpr Operand polar_angle{
    'Q',
    Role::angle,
    Need::optional,
    {},
    {},
    {"polar angle of the end point", "angle polaire du point d'arrivée", "ángulo polar del punto final"}};

}  // namespace fagorc::frontend::fagor8055
