// The nine axis names of a control (8055 T 3.1) and sets of values by axis.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace fagorc {

/// An axis letter. X Y Z main, U V W parallel to them, A B C rotary about them (DIN 66217; 8055 T 3.1).
enum class Axis : std::uint8_t { X, Y, Z, U, V, W, A, B, C };

inline constexpr std::size_t axis_count = 9;

/// The axes in the order in which a block names them (8055 T 5: X Y Z U V W A B C).
inline constexpr std::array<Axis, axis_count> all_axes = {Axis::X, Axis::Y, Axis::Z, Axis::U, Axis::V,
                                                          Axis::W, Axis::A, Axis::B, Axis::C};

constexpr std::size_t index(Axis a) {
    return static_cast<std::size_t>(a);
}
constexpr char letter(Axis a) {
    return "XYZUVWABC"[index(a)];
}
constexpr bool is_rotary(Axis a) {
    return a >= Axis::A;
}

/// Index of the axis by letter from A; -1 for a letter that names none.
inline constexpr auto axis_by_letter = [] {
    std::array<std::int8_t, 26> table{};
    table.fill(-1);
    for (Axis a : all_axes) table[static_cast<std::size_t>(letter(a) - 'A')] = static_cast<std::int8_t>(a);
    return table;
}();

/// The axis of an upper-case letter; nothing for a character that names no axis.
constexpr std::optional<Axis> axis_of(char c) {
    const std::size_t at = static_cast<unsigned char>(c - 'A');
    if (at >= axis_by_letter.size() || axis_by_letter[at] < 0) return std::nullopt;
    return static_cast<Axis>(axis_by_letter[at]);
}

/// The centre letter that belongs to an axis: X U A -> I, Y V B -> J, Z W C -> K (8055 T 6.3).
constexpr char centre_letter(Axis a) {
    return "IJK"[index(a) % 3];
}

/// One value for each axis.
template <class T>
struct PerAxis : std::array<T, axis_count> {
    using Base = std::array<T, axis_count>;
    constexpr T& operator[](Axis a) { return Base::operator[](index(a)); }
    constexpr const T& operator[](Axis a) const { return Base::operator[](index(a)); }
};

/// A set of axes.
struct AxisSet {
    std::uint16_t bits = 0;
    constexpr bool has(Axis a) const { return (bits >> index(a)) & 1; }
    constexpr void add(Axis a) { bits = static_cast<std::uint16_t>(bits | (1u << index(a))); }
    constexpr void remove(Axis a) { bits = static_cast<std::uint16_t>(bits & ~(1u << index(a))); }
    constexpr bool empty() const { return bits == 0; }
    /// More than one axis.
    constexpr bool several() const { return (bits & (bits - 1)) != 0; }
    /// The axes that both sets have.
    friend constexpr AxisSet operator&(AxisSet a, AxisSet b) {
        return {static_cast<std::uint16_t>(a.bits & b.bits)};
    }
    friend constexpr bool operator==(AxisSet, AxisSet) = default;
};

/// Values for some of the axes, e.g. the words of `G92 X0 Z0`, or axis names in the order written (`G74 X Z`).
struct AxisValues {
    AxisSet given;
    PerAxis<double> value{};
    std::array<Axis, axis_count> order{};  ///< the given axes in the order in which the block names them
    std::uint8_t count = 0;

    constexpr void set(Axis a, double v) {
        if (!given.has(a)) order[count++] = a;
        given.add(a);
        value[a] = v;
    }
    constexpr std::optional<double> get(Axis a) const { return given.has(a) ? std::optional(value[a]) : std::nullopt; }
};

/// The two axes of the active plane: abscissa u and ordinate v. Angles grow from +u to +v, G03 turns that way
/// (8055 T 3.2). The lathe plane G18 has u = Z and v = X.
struct Plane {
    Axis u = Axis::Z;
    Axis v = Axis::X;
    constexpr bool has(Axis a) const { return a == u || a == v; }
    friend constexpr bool operator==(Plane, Plane) = default;
};

inline constexpr Plane plane_g17{Axis::X, Axis::Y};
inline constexpr Plane plane_g18{Axis::Z, Axis::X};
inline constexpr Plane plane_g19{Axis::Y, Axis::Z};

/// Whether the axes are those of G17, G18 or G19 the other way round (G16 X Z): such a plane is seen from behind, what
/// is clockwise in it is counter-clockwise in the plane of the G code.
constexpr bool is_mirrored(Plane p) {
    const Plane front{p.v, p.u};
    return front == plane_g17 || front == plane_g18 || front == plane_g19;
}

}  // namespace fagorc
