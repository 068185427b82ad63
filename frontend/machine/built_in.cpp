// The built-in lathe: the machine that a program is read for when no machine file says another.
#include "frontend/machine/machine.hpp"

namespace fagorc::frontend {
namespace {

using machine::AxisType;
using machine::Machine;
using machine::Misc;

/// All nine letters: a control has at most seven of them (8055 T 3.1), but nobody knows which.
void set_axes(Machine& m) {
    for (Axis a : all_axes) m.axes[a].exists = true;
    for (Axis a : {Axis::A, Axis::B, Axis::C}) m.axes[a].rollover = true;  // 8055 T 3.7
    m.axes[Axis::A].type = AxisType::positioning;
    m.axes[Axis::B].type = AxisType::hirth;
    m.axes[Axis::C].type = AxisType::rotary;
}

/// The M table as the manual recommends it: stops and ends after the motion (8055 T 5.7).
void set_misc(Machine& m) {
    Misc after_motion;
    after_motion.before = false;
    for (std::uint16_t number : std::initializer_list<std::uint16_t>{0, 1, 2, 5, 30}) m.misc[number] = after_motion;
    for (std::uint16_t number : std::initializer_list<std::uint16_t>{3, 4}) m.misc[number] = Misc{};
}

}  // namespace

Machine built_in_lathe(const control::Dialect& dialect) {
    Machine m;
    m.control = dialect.name;
    m.power_on = dialect.power_on;
    set_axes(m);
    set_misc(m);
    m.tool_count = 99;
    m.default_offset.nose = 0.4;
    m.default_offset.tip = 3;
    m.default_tool.insert_width = 3;
    for (int row = 1; row <= 20; ++row) m.origins[row] = {};  // G54..G59 and the rows that G159 N7..N20 reach
    m.home_subroutine = 9990;
    m.interrupt_subroutines = {35, 36, 37, 38};
    return m;
}

}  // namespace fagorc::frontend
