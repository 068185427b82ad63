// The words that a construct takes: what each is, when it must be written, which values it allows, what it fills.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>

#include "ir/base/axis.hpp"
#include "ir/base/text.hpp"

namespace fagorc::control {

/// What an operand is: decides unit, diameter, scale and mirror of its value.
enum class Role : std::uint8_t {
    none,
    coordinate,    ///< a coordinate: active length unit; of X as G151/G152 says; of a rotary axis in degrees
    axis_name,     ///< a bare axis letter that names the axis (G74 X)
    centre,        ///< I J K of an arc, from its start: active unit, always a radius
    centre_point,  ///< I J K as a coordinate of the axes that the letter serves (G06, G09)
    abscissa, ordinate,   ///< an absolute coordinate of the plane's first, second axis under any letter (G93 I J, G81 Q)
    machine_coordinate,   ///< a machine coordinate of the letter's axis, X always a radius (G20)
    distance,      ///< a signed way along the letter's axis, X a radius: a mirror turns it (G233)
    distance_u, distance_v,   ///< a signed way along the plane's first, second axis, X a radius: a mirror turns it
    length,        ///< a true length: active unit, never a diameter; its sign, if any, selects a variant
    lead,          ///< advance of one spindle turn, active unit; not scaled
    angle,         ///< degrees
    feed, speed,   ///< by the active feed and speed mode
    factor, percent,
    count, row, choice,   ///< whole numbers: how many, which table row, which variant
    label, program,       ///< a block label, a program number
    hundredths     ///< time in 1/100 s
};

enum class Need : std::uint8_t {
    required,
    optional,
    together,      ///< with the others of this need, or none of them (G93 I J)
    alternative    ///< exactly one of these; the axis words count as one (G72 S or axes)
};

/// Allowed values, in the operand's own unit as programmed.
struct Range {
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    bool above = false;     ///< `least` itself is not allowed
    bool whole = false;     ///< no decimals
    bool not_zero = false;  ///< 0 is not allowed

    /// True for a value inside, and for NaN, a value that is not known.
    bool allows(double v) const {
        if (v > most || (above ? v <= least : v < least)) return false;
        if (not_zero && v == 0) return false;
        return !whole || std::isnan(v) || v == std::trunc(v);
    }
};

/// The range as a reader sees it: "0 .. 255", "> 0", ">= 0"; empty where every number is allowed.
std::string to_string(const Range& range);

/// How an operand reaches the member of the neutral function that it fills, and comes back for printing.
struct Slot {
    void (*set)(void* function, Axis axis, double value) = nullptr;
    std::optional<double> (*get)(const void* function, Axis axis) = nullptr;
};

namespace detail {
template <class T> struct member_of;
template <class C, class M> struct member_of<M C::*> { using owner = C; using member = M; };
}  // namespace detail

/// The slot of a member pointer: a number, an optional number, or values by axis.
template <auto Member>
inline constexpr Slot at = [] {
    using Owner = typename detail::member_of<decltype(Member)>::owner;
    using Type = typename detail::member_of<decltype(Member)>::member;
    if constexpr (std::is_same_v<Type, AxisValues>)
        return Slot{[](void* f, Axis a, double v) { (static_cast<Owner*>(f)->*Member).set(a, v); },
                    [](const void* f, Axis a) { return (static_cast<const Owner*>(f)->*Member).get(a); }};
    else
        return Slot{[](void* f, Axis, double v) { static_cast<Owner*>(f)->*Member = static_cast<Type>(v); },
                    [](const void* f, Axis) { return std::optional<double>(static_cast<const Owner*>(f)->*Member); }};
}();

/// The slot of a bool member that a letter sets by being there, with or without a value (G77 S).
template <auto Member>
inline constexpr Slot named = [] {
    using Owner = typename detail::member_of<decltype(Member)>::owner;
    return Slot{[](void* f, Axis, double) { static_cast<Owner*>(f)->*Member = true; },
                [](const void* f, Axis) {
                    return static_cast<const Owner*>(f)->*Member ? std::optional<double>(0) : std::nullopt;
                }};
}();

/// The address of an operand that stands for all axis letters.
inline constexpr char any_axis = '*';

/// A word that a construct takes.
struct Operand {
    char address = 0;         ///< the letter, or any_axis; a letter of its own goes before any_axis (B of G51)
    Role role = Role::none;
    Need need = Need::optional;
    Range range{};
    Slot slot{};              ///< empty for Takes::motion: the executor's motion reads these words
    Text text{};
};

}  // namespace fagorc::control
