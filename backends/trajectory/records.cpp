#include "backends/trajectory/records.hpp"

namespace fagorc::backends::trajectory {
namespace {

template <class E>
constexpr std::uint8_t code(E e) {
    return static_cast<std::uint8_t>(e);
}

// The numbers of docs/trajectory-format.md: an enumerator put in between would change the meaning of old files.
using namespace program;
using Event = operation::Event::Kind;
using Turn = operation::SpindleTurn;
using Why = operation::Barrier::Why;
static_assert(code(Motion::rapid) == 0 && code(Motion::variable_thread) == 5);
static_assert(code(PlaneCode::xy) == 0 && code(PlaneCode::by_axes) == 3);
static_assert(code(Distance::incremental) == 1 && code(LengthUnit::inch) == 1 && code(XWord::radius) == 1);
static_assert(code(FeedMode::per_minute) == 0 && code(FeedMode::inverse_time) == 2);
static_assert(code(SpeedMode::constant_surface) == 1 && code(Spindle::second) == 1);
static_assert(code(Corner::round) == 0 && code(Corner::controlled) == 2 && code(Corner::look_ahead) == 3);
static_assert(code(Side::left) == 1 && code(Side::right) == 2);
static_assert(code(Turn::stopped) == 0 && code(Turn::clockwise) == 1 && code(Turn::oriented) == 3);
static_assert(code(Axis::X) == 0 && code(Axis::Z) == 2 && code(Axis::C) == 8);
static_assert(code(Event::misc) == 0 && code(Event::tool) == 3 && code(Event::home) == 7 &&
              code(Event::program_end) == 9);
static_assert(code(Why::preparation) == 0 && code(Why::live) == 1 && code(Why::position) == 2);

}  // namespace

StateRecord state_record(const operation::Tables& tables, const Situation& situation) {
    const operation::State& s = tables.states[situation.state];
    const operation::Frame& f = tables.frames[situation.frame];
    const Modal& m = s.modal;
    StateRecord r;
    r.origin = f.offset;
    r.speed = situation.speed;
    r.speed_limit = s.speed_limit;
    r.nose = s.nose;
    r.length_x = s.length_x;
    r.length_z = s.length_z;
    r.acceleration = s.look_ahead.acceleration;
    r.contour_error = s.look_ahead.error;
    r.corner_angle = s.look_ahead.corner_angle;
    r.tool = s.tool;
    r.offset = s.offset;
    r.gear = s.gear;
    r.tip = s.tip;
    r.turn = code(s.turn);
    r.flags = static_cast<std::uint8_t>((f.machine ? machine_frame : 0) | (s.stop_disabled ? stop_disabled : 0) |
                                        (s.feed_hold_disabled ? feed_hold_disabled : 0) |
                                        (s.single_block_joined ? joined_blocks : 0));
    r.motion = code(m.motion);
    r.plane_code = code(m.plane_code);
    r.plane_u = code(m.plane.u);
    r.plane_v = code(m.plane.v);
    r.distance = code(m.distance);
    r.unit = code(m.unit);
    r.x_word = code(m.x);
    r.feed_mode = code(m.feed);
    r.speed_mode = code(m.speed);
    r.spindle = code(m.spindle);
    r.corner = code(m.corner);
    r.side = code(m.side);
    return r;
}

}  // namespace fagorc::backends::trajectory
