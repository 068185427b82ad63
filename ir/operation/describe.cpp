#include "ir/operation/describe.hpp"

#include <fmt/format.h>

namespace fagorc::operation {
namespace {

std::string point(std::string_view prefix, Point p, Plane plane) {
    return fmt::format(" {}{}={:.6f} {}{}={:.6f}", prefix, letter(plane.u), p.u + 0.0, prefix, letter(plane.v),
                       p.v + 0.0);
}

std::string feed(const Operation& o, const State& state) {
    static constexpr std::string_view units[] = {"mm/min", "mm/rev", "1/min"};
    return fmt::format(" F={:.6f} {}", o.at.feed, units[static_cast<std::size_t>(state.modal.feed)]);
}

std::string text(const Line& l, const Operation& o, const State& s) {
    return (l.rapid ? "rapid" : "line") + point("", l.end, s.modal.plane) + (l.rapid ? "" : feed(o, s));
}
std::string text(const Arc& a, const Operation& o, const State& s) {
    return std::string(a.ccw ? "ccw" : "cw") + point("", a.end, s.modal.plane) + point("c", a.centre, s.modal.plane) +
           (a.full ? " full" : "") + feed(o, s);
}
std::string text(const Thread& t, const Operation&, const State& s) {
    return "thread" + point("", t.end, s.modal.plane) + fmt::format(" lead={:.6f} angle={:.6f}", t.lead, t.angle);
}
std::string text(const Dwell& d, const Operation&, const State&) {
    return fmt::format("dwell {:.6f} s", d.seconds);
}
std::string text(const Event& e, const Operation&, const State&) {
    static constexpr std::string_view names[] = {"misc",         "spindle_angle", "live_tool", "tool",
                                                 "offset",       "message",       "error",     "home",
                                                 "graphic_zone", "program_end"};
    std::string line = fmt::format("event {} {}", names[static_cast<std::size_t>(e.kind)], e.value);
    for (Axis a : all_axes)
        if (e.axes.has(a)) line += std::string(" ") + letter(a);
    return line;
}
std::string text(const Barrier& b, const Operation&, const State&) {
    static constexpr std::string_view names[] = {"preparation", "live", "position"};
    return fmt::format("barrier {}", names[static_cast<std::size_t>(b.why)]);
}

}  // namespace

std::string describe(const Operation& o, const Tables& tables) {
    const State& state = tables.states[o.at.state];
    std::string line = fmt::format("{} ", o.at.line);
    line += std::visit([&](const auto& what) { return text(what, o, state); }, o.what);
    for (Axis a : all_axes)
        if (o.moved.has(a)) line += fmt::format(" {}={:.6f}", letter(a), o.others[a] + 0.0);
    if (tables.frames[o.at.frame].machine) line += " G53";
    return line;
}

}  // namespace fagorc::operation
