#include "passes/execute/zero_offsets.hpp"

namespace fagorc::passes {

void ZeroOffsets::select(std::uint16_t row, const PerAxis<double>& values) {
    row_ = row;
    absolute_ = values;
    if (increment_row_ != 0) {
        increment_row_ = 0;
        increment_ = {};
    }
    sum();
}

void ZeroOffsets::add(std::uint16_t row, const PerAxis<double>& values) {
    increment_row_ = row;
    increment_ = values;
    sum();
}

void ZeroOffsets::shift(const AxisValues& values) {
    if (increment_row_ != 0 || values.count == 0) increment_ = {};
    increment_row_ = 0;
    for (Axis a : all_axes)
        if (values.given.has(a)) increment_[a] = values.value[a];
    sum();
}

void ZeroOffsets::preset(Axis axis, double machine, double value) {
    row_ = 0;
    absolute_[axis] = machine - value - increment_[axis];
    sum();
}

void ZeroOffsets::sum() {
    for (Axis a : all_axes) total_[a] = absolute_[a] + increment_[a];
}

}  // namespace fagorc::passes
