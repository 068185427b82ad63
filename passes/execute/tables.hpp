// The tables of the control that a program reads and writes: tools, offsets, magazine, zero offsets (8055 T 11.2.2,
// 11.2.3).
#pragma once

#include <string_view>

#include "ir/base/axis.hpp"
#include "ir/control/operand.hpp"
#include "ir/machine/machine.hpp"

namespace fagorc::passes {

/// A column of a table by the name of its variable. Lengths in mm, X as a radius, angles in degrees.
struct TableColumn {
    std::string_view name;
    double (*get)(const machine::Machine& machine, long row, Axis axis);
    void (*set)(machine::Machine& machine, long row, Axis axis, double value);  ///< null: read only
    control::Range range{};                                                     ///< of the values that it takes
};

/// Null for a variable that is no column of a table.
const TableColumn* find_column(std::string_view name);

/// The row of the zero-offset table that an index names: 1..20, and 54..59 for G54..G59 = rows 1..6; 0 for none
/// (8055 T 11.2.3).
int origin_row(long index);

}  // namespace fagorc::passes
