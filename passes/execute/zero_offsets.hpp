// The zero offsets in force: an absolute and an incremental part for each axis (8055 T 4.4.1 to 4.4.2).
#pragma once

#include <cstdint>

#include "ir/base/axis.hpp"

namespace fagorc::passes {

/// Machine coordinate = part coordinate + total(). Millimetres, X as a radius; degrees for rotary axes.
class ZeroOffsets {
  public:
    const PerAxis<double>& total() const { return total_; }
    /// The incremental part alone, and the row of the table that it comes from; 0 for none or for values.
    const PerAxis<double>& increment() const { return increment_; }
    std::uint16_t increment_row() const { return increment_row_; }
    /// Row of the absolute part; 0 for none and for a preset.
    std::uint16_t row() const { return row_; }

    /// A row of the table replaces the absolute part. An increment from the table ends, one by values stays (4.6).
    void select(std::uint16_t row, const PerAxis<double>& values);
    /// A row of the table becomes the incremental part, in place of any other increment.
    void add(std::uint16_t row, const PerAxis<double>& values);
    /// Incremental values axis by axis; none: no increment any more. They end an increment from the table.
    void shift(const AxisValues& values);
    /// The point that stands at `machine` takes the coordinate `value`: the total says so, the increment stays (4.4).
    void preset(Axis axis, double machine, double value);
    /// No offset at all.
    void cancel() { *this = {}; }

  private:
    void sum();

    PerAxis<double> absolute_{}, increment_{}, total_{};
    std::uint16_t row_ = 0, increment_row_ = 0;
};

}  // namespace fagorc::passes
