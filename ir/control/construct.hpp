// Rows of a control's language tables: what a word means, which operands it takes, how it is described.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <variant>

#include "ir/base/axis.hpp"
#include "ir/base/text.hpp"
#include "ir/control/operand.hpp"
#include "ir/diag/id.hpp"
#include "ir/program/function.hpp"
#include "ir/program/modal.hpp"

namespace fagorc::control {

enum class Support : std::uint8_t { executed, planned };

/// What else may stand in the block (8055 T 5.1).
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
    bool lasts = false;               ///< modal without being a member of a group (G72, G77)
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

    constexpr bool modal() const { return lasts || group != program::Group::none; }
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
