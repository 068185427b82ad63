// Rows of a control's table of variables.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "ir/base/axis.hpp"
#include "ir/base/text.hpp"
#include "ir/control/construct.hpp"

namespace fagorc::control {

/// Where the value of a variable comes from (derived from what 8055 T 11.2 says of each).
enum class Knowledge : std::uint8_t {
    program,     ///< the program's own state
    table,       ///< tool, offset, magazine, origin tables
    machine,     ///< machine parameters
    overridable, ///< the program's value unless PLC or DNC overrides it
    live         ///< only the running machine knows
};

enum class IndexForm : std::uint8_t {
    none,
    required,
    optional,            ///< without an index the name is another, read-only value (ORGX: the offset in force)
    label_and_program    ///< GPOSX N99 P100
};

/// One variable or family. A family by axis has `per_axis`; its names are root + axis letter.
struct Variable {
    std::string_view name{};
    bool per_axis = false;
    IndexForm index = IndexForm::none;
    std::uint32_t least_index = 0, most_index = 0;
    bool readable = true, writable = false;       ///< from the part program
    bool stops_preparation = false;
    bool plc_resource = false;                    ///< an index out of range is alarm 1051 instead of 1052
    Knowledge knowledge = Knowledge::live;
    Role unit = Role::none;
    Support support = Support::planned;
    std::optional<double> initial{};              ///< value before the program writes it, where only the program does
    Text title{};
    std::string_view section{};
};

/// The payload of a variable token.
constexpr std::uint16_t variable_payload(std::uint16_t row, int axis_or_minus_one) {
    return static_cast<std::uint16_t>(row * 16 + axis_or_minus_one + 1);
}
constexpr std::uint16_t variable_row(std::uint16_t payload) { return payload / 16; }
constexpr int variable_axis(std::uint16_t payload) { return payload % 16 - 1; }

}  // namespace fagorc::control
