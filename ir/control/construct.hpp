// Rows of a control's language tables: what a word means, which operands it takes, how it is described.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

#include "ir/base/axis.hpp"
#include "ir/base/text.hpp"
#include "ir/diag/id.hpp"
#include "ir/program/function.hpp"
#include "ir/program/modal.hpp"

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

enum class Support : std::uint8_t { executed, planned };

/// What else may stand in the block (8055 T 9.1).
enum class Company : std::uint8_t {
    any,
    alone,            ///< nothing else in the block: an error
    alone_expected,   ///< nothing else, but the manual does not say so: a warning
    no_other_g,       ///< no other G code
    alone_without_operands   ///< alone in the form without operands (G04)
};

/// Which words after the code are its operands.
enum class Takes : std::uint8_t {
    none,             ///< none: the words belong to the motion, the feed and so on
    motion,           ///< its operands are words of the motion, in this block and while its group keeps it
    listed,           ///< the words of the block whose letters its table lists
    next,             ///< only the words that follow the code at once (G36 R)
    all,              ///< every word after it; they lose their ordinary meaning (canned cycles)
    arguments         ///< local parameters of a subroutine (G180 A1 P2=3)
};

/// One construct: a G or M code. The functions make and find its neutral function.
struct Construct {
    char letter = 'G';
    std::uint16_t number = 0;
    std::string_view code{};          ///< as the manual writes it: "G01", "G77S"
    program::Group group = program::Group::none;
    std::uint8_t setting = 0;         ///< value in its group: an enumerator of modal.hpp
    Support support = Support::executed;
    Company company = Company::any;
    Takes takes = Takes::none;
    std::string_view syntax{};        ///< as the manual prints it: "G04 [K1..99999]"
    std::string_view snippet{};       ///< a small valid use
    std::string_view section{};       ///< of the manual: "8055 T 7.1"
    Text title{};
    std::span<const Operand> operands{};
    program::Function (*make)() = nullptr;
    void* (*target)(program::Function&) = nullptr;
    std::uint8_t least_axes = 0, most_axes = axis_count;   ///< how many axis words, when it takes any
    diag::Id misuse = diag::Id::operands_wrong;             ///< operands missing or too many: code, syntax
    diag::Id out_of_range = diag::Id::operand_out_of_range; ///< an operand's value: letter, code, range

    /// The operand of a letter; null where the construct has none.
    constexpr const Operand* operand(char address) const {
        for (const Operand& o : operands)
            if (o.address == address) return &o;
        if (!axis_of(address)) return nullptr;
        for (const Operand& o : operands)
            if (o.address == any_axis) return &o;
        return nullptr;
    }
};

/// Fills `make` and `target` of a row: `.make = makes<program::Dwell>, .target = target_of<program::Dwell>`.
template <class F>
inline constexpr auto makes = +[]() -> program::Function { return F{}; };
template <class F>
inline constexpr auto target_of = +[](program::Function& f) -> void* { return &std::get<F>(f); };

/// A missing language, an address twice or a range the wrong way round does not compile.
consteval bool well_formed(const Construct& c) {
    if (!c.title.complete() || c.code.empty() || c.syntax.empty() || c.snippet.empty() || c.section.empty())
        return false;
    for (std::size_t i = 0; i < c.operands.size(); ++i) {
        const Operand& o = c.operands[i];
        if (!o.text.complete() || o.range.least > o.range.most || o.role == Role::none) return false;
        if ((c.takes == Takes::motion) == (o.slot.set != nullptr)) return false;
        for (std::size_t k = 0; k < i; ++k)
            if (c.operands[k].address == o.address) return false;
    }
    if (c.takes == Takes::none || c.takes == Takes::arguments) return c.operands.empty();
    return c.takes == Takes::motion || (!c.operands.empty() && c.make && c.target);
}

}  // namespace fagorc::control
