// Rows of the machine file's key tables: what a key is called, what it takes, which member it fills.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <type_traits>

#include "ir/control/operand.hpp"
#include "ir/machine/machine.hpp"

namespace fagorc::frontend::machine_file {

enum class Kind : std::uint8_t {
    number,
    whole,
    boolean,  ///< true, false, 1, 0, "YES", "NO" (the control's tables write YES and NO)
    choice    ///< one of the names, or its index from 0 (the control's tables write numbers)
};

/// What a number measures, which decides the factor of a file in inches. `rotary` counts degrees on A B C.
enum class Measure : std::uint8_t { none, length, axis_length };

struct Key {
    std::string_view name;
    Kind kind = Kind::number;
    /// Stores the value in the owner of the table: a boolean as 0 or 1, a choice as its index.
    void (*set)(void* owner, double value) = nullptr;
    control::Range range = {};
    Measure measure = Measure::none;
    std::span<const std::string_view> choices = {};
};

namespace detail {
template <class T>
struct stored {
    using type = T;
};
template <class T>
struct stored<std::optional<T>> {
    using type = T;
};
template <class T>
struct owner_of;
template <class C, class M>
struct owner_of<M C::*> {
    using type = C;
};

template <class Owner>
constexpr Owner& reach(Owner& owner) {
    return owner;
}
template <class Owner, class Member, class... Deeper>
constexpr auto& reach(Owner& owner, Member member, Deeper... deeper) {
    return reach(owner.*member, deeper...);
}
}  // namespace detail

/// Stores into a member, or a member of a member: `into<&Machine::power_on, &Modal::motion>`.
template <auto Member, auto... Deeper>
inline constexpr auto into = +[](void* owner, double value) {
    using Owner = typename detail::owner_of<decltype(Member)>::type;
    auto& target = detail::reach(*static_cast<Owner*>(owner), Member, Deeper...);
    using Stored = typename detail::stored<std::remove_reference_t<decltype(target)>>::type;
    target = static_cast<Stored>(value);
};

/// The same for a number of which 0 says "none", as the control's tables do.
template <auto Member>
inline constexpr auto into_unless_zero = +[](void* owner, double value) {
    using Owner = typename detail::owner_of<decltype(Member)>::type;
    auto& target = static_cast<Owner*>(owner)->*Member;
    target.reset();
    if (value != 0) target = static_cast<typename std::remove_reference_t<decltype(target)>::value_type>(value);
};

/// Two keys are one when they differ in `-` and `_` only.
bool same_name(std::string_view a, std::string_view b);

/// [machine], in the order in which they are applied: first the unit and the meaning of X that others depend on.
std::span<const Key> machine_keys();
std::span<const Key> modal_keys();
std::span<const Key> axis_keys();
std::span<const Key> spindle_keys();
std::span<const Key> start_keys();  ///< besides the axis letters
std::span<const Key> offset_keys();
std::span<const Key> tool_keys();
std::span<const Key> misc_keys();
std::span<const Key> policy_keys();
/// Parameters of the control that change nothing of what a program does; they are kept by name.
std::span<const std::string_view> other_parameters();
/// Whether a key is kept by its name: one of those, or a variable by which programs read machine parameters: MPG12,
/// MPX5, MPS0, MPSS3, MPAS1, MPLC4 (8055 T 11.2.4).
bool is_kept_by_name(std::string_view name);

}  // namespace fagorc::frontend::machine_file
