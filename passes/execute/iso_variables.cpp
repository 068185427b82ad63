// Variables that read the state of the program: position, offsets, feed, speed, tool, functions in force (8055 T 11.2).
#include <cmath>
#include <utility>

#include "passes/execute/iso_control.hpp"

namespace fagorc::passes {

using control::Role;
using program::Group;
using Control = IsoRunner::Control;

namespace {

/// An index or an axis of the name; the axis is X where the name has none.
struct Request {
    Axis axis = Axis::X;
    std::optional<long> index;
};

using Value = std::optional<double>;
using Read = Value (*)(const Control&, Request);

double speed(const Control& c, program::SpeedMode mode) {
    return c.speeds[static_cast<std::size_t>(mode)].value_or(0);
}

/// Feeds are kept by mode, so each variable has its own (8055 T 11.2.6).
template <program::FeedMode mode>
Value feed(const Control& c, Request) {
    const double f = c.feeds[static_cast<std::size_t>(mode)];
    return mode == program::FeedMode::inverse_time ? f : f / c.unit;
}

Value surface_speed(const Control& c, Request) {
    const bool feet = c.state.modal.unit == program::LengthUnit::inch;
    return speed(c, program::SpeedMode::constant_surface) / (feet ? 0.3048 : 1);
}

Value spindle_speed(const Control& c, Request) {
    const bool constant = c.state.modal.speed == program::SpeedMode::constant_surface;
    return constant ? c.surface_rpm() : speed(c, program::SpeedMode::rpm);
}

/// Zero offsets are radii, whatever G151 says (8055 T 11.2.3).
Value length_of(const Control& c, Axis axis, double value) {
    return is_rotary(axis) ? value : value / c.unit;
}

/// Axis numbers count the machine's axes in programming order: X Z of a lathe with Y are 1 and 3 (8055 T 11.2.19).
int axis_number(const Control& c, Axis axis) {
    int n = 0;
    for (Axis a : all_axes) {
        n += c.session.machine.axes[a].exists;
        if (a == axis) break;
    }
    return n;
}

std::optional<std::uint8_t> setting(const program::Modal& m, Group group) {
    switch (group) {
        case Group::motion:
            return static_cast<std::uint8_t>(m.motion);
        case Group::plane:
            return static_cast<std::uint8_t>(m.plane_code);
        case Group::distance:
            return static_cast<std::uint8_t>(m.distance);
        case Group::unit:
            return static_cast<std::uint8_t>(m.unit);
        case Group::diameter:
            return static_cast<std::uint8_t>(m.x);
        case Group::feed:
            return static_cast<std::uint8_t>(m.feed);
        case Group::speed:
            return static_cast<std::uint8_t>(m.speed);
        case Group::spindle:
            return static_cast<std::uint8_t>(m.spindle);
        case Group::corner:
            return static_cast<std::uint8_t>(m.corner);
        case Group::compensation:
            return static_cast<std::uint8_t>(m.side);
        case Group::none:
        case Group::origin:
        case Group::shift:
        case Group::count_:
            break;
    }
    return std::nullopt;
}

/// GSn: 1 while the function is in force (8055 T 11.2.19).
Value function_state(const Control& c, Request r) {
    const control::Construct* row = c.session.dialect.find('G', static_cast<std::uint16_t>(r.index.value_or(0)));
    if (row == nullptr) return 0;
    if (const auto s = setting(c.state.modal, row->group)) return *s == row->setting;
    if (row->make == nullptr) return 0;
    const program::Function f = row->make();
    if (const auto* o = std::get_if<program::AbsoluteOrigin>(&f)) return o->row && *o->row == c.offsets.row();
    if (const auto* o = std::get_if<program::IncrementalOrigin>(&f))
        return o->row && *o->row == c.offsets.increment_row();
    if (const auto* o = std::get_if<program::Mirror>(&f)) return o->off;
    return 0;
}

/// MSn: 1 while what the function has set is so (8055 T 11.2.19).
Value misc_state(const Control& c, Request r) {
    using operation::SpindleTurn;
    using Turn = program::SpindleCommand::Turn;
    const auto number = static_cast<std::uint16_t>(r.index.value_or(0));
    const control::Construct* row = c.session.dialect.find('M', number);
    if (row == nullptr || row->make == nullptr) return c.sent.count(number) != 0;
    const program::Function f = row->make();
    if (const auto* gear = std::get_if<program::SpindleGear>(&f)) return gear->gear == c.state.gear;
    if (std::holds_alternative<program::OrientedStop>(f)) return c.state.turn == SpindleTurn::oriented;
    if (const auto* spindle = std::get_if<program::SpindleCommand>(&f)) {
        if (spindle->turn == Turn::stop) return c.state.turn == SpindleTurn::stopped;
        return c.state.turn ==
               (spindle->turn == Turn::clockwise ? SpindleTurn::clockwise : SpindleTurn::counter_clockwise);
    }
    return 0;
}

constexpr std::pair<std::string_view, Read> readers[] = {
    {"TOOL", [](const Control& c, Request) -> Value { return c.state.tool; }},
    {"TOD", [](const Control& c, Request) -> Value { return c.state.offset; }},
    {"NXTOOL", [](const Control& c, Request) -> Value { return c.next_tool ? c.next_tool->tool : c.state.tool; }},
    {"NXTOD", [](const Control& c, Request) -> Value { return c.next_tool ? c.next_tool->offset : c.state.offset; }},
    {"HTOR", [](const Control& c, Request) -> Value { return c.state.nose / c.unit; }},
    {"ORG", [](const Control& c, Request r) { return length_of(c, r.axis, c.offsets.total()[r.axis]); }},
    {"ADDORG", [](const Control& c, Request r) { return length_of(c, r.axis, c.offsets.increment()[r.axis]); }},
    {"EXTORG", [](const Control& c, Request) -> Value { return c.offsets.row(); }},
    {"PORGF", [](const Control& c, Request) -> Value { return c.polar.origin.u / c.scale[c.state.modal.plane.u]; }},
    {"PORGS", [](const Control& c, Request) -> Value { return c.polar.origin.v / c.scale[c.state.modal.plane.v]; }},
    {"PPOS", [](const Control& c, Request r) -> Value { return c.programmed[r.axis] / c.scale[r.axis]; }},
    {"FEED", feed<program::FeedMode::per_minute>},
    {"PRGF", feed<program::FeedMode::per_minute>},
    {"FPREV", feed<program::FeedMode::per_revolution>},
    {"PRGFPR", feed<program::FeedMode::per_revolution>},
    {"PRGFIN", feed<program::FeedMode::inverse_time>},
    {"SPEED", spindle_speed},
    {"PRGS", [](const Control& c, Request) -> Value { return speed(c, program::SpeedMode::rpm); }},
    {"CSS", surface_speed},
    {"PRGCSS", surface_speed},
    {"SLIMIT", [](const Control& c, Request) -> Value { return c.state.speed_limit; }},
    {"PRGSL", [](const Control& c, Request) -> Value { return c.state.speed_limit; }},
    {"PRGSP", [](const Control& c, Request) -> Value { return c.oriented_angle; }},
    {"ASPROG", [](const Control& c, Request) -> Value { return c.live_tool_speed; }},
    {"PRGN",
     [](const Control& c, Request) -> Value {
         const auto number = c.session.program->number();
         return number ? *number : -1.0;  // -1: a program without a number
     }},
    {"GS", function_state},
    {"MS", misc_state},
    {"PLANE",
     [](const Control& c, Request) -> Value {
         return axis_number(c, c.state.modal.plane.u) * 16 + axis_number(c, c.state.modal.plane.v);
     }},
    {"DIAM", [](const Control& c, Request) -> Value { return c.state.modal.x == program::XWord::diameter; }},
};

}  // namespace

std::optional<double> IsoRunner::variable(std::uint16_t row, int axis, std::optional<long> index) {
    const std::string_view name = control_->session.dialect.variables[row].name;
    for (const auto& [known, read] : readers)
        if (known == name)
            return read(*control_, {axis < 0 ? Axis::X : all_axes[static_cast<std::size_t>(axis)], index});
    return std::nullopt;
}

bool IsoRunner::assign(std::uint16_t row, int, double value) {
    Control& c = *control_;
    const std::string_view name = c.session.dialect.variables[row].name;
    if (is_unknown(value)) {
        c.session.blocked = true;
        return true;
    }
    if (name == "DIAM") {  // for the blocks that follow, like G151 and G152 (8055 T 11.2.19)
        c.state.modal.x = value == 0 ? program::XWord::radius : program::XWord::diameter;
        c.units_changed();
    } else if (name == "HTOR") {  // the tables keep their radius (8055 T 11.2.2)
        c.state.nose = value * c.unit;
    } else {
        return false;
    }
    c.state_changed();
    return true;
}

}  // namespace fagorc::passes
