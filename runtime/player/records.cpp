#include "runtime/player/records.hpp"

namespace fagorc::player {
namespace {

/// Takes the fields of a record one after the other.
class Fields {
  public:
    explicit Fields(const std::byte* p) : p_(p) {}
    template <class... T>
    void operator()(T&... values) {
        (take(values), ...);
    }

  private:
    template <class T>
    void take(T& value) {
        value = load<T>(p_);
        p_ += sizeof(T);
    }
    const std::byte* p_;
};

}  // namespace

Position read_position(const std::byte* p) {
    Position position;
    std::memcpy(position.data(), p, sizeof position);
    return position;
}

State read_state(const std::byte* record) {
    State s;
    std::uint8_t flags = 0;
    s.origin = read_position(record);
    Fields fields(record + sizeof(Position));
    fields(s.speed, s.speed_limit, s.nose, s.length_x, s.length_z, s.acceleration, s.contour_error, s.corner_angle);
    fields(s.tool, s.offset, s.gear, s.tip, s.turn, flags);
    fields(s.motion, s.plane_code, s.plane_u, s.plane_v, s.distance, s.unit, s.x_word);
    fields(s.feed_mode, s.speed_mode, s.spindle, s.corner, s.side);
    s.machine_frame = flags & 1;
    s.stop_disabled = flags & 2;
    s.feed_hold_disabled = flags & 4;
    s.joined_blocks = flags & 8;
    return s;
}

Chain read_chain(const std::byte* record) {
    Chain c;
    Fields{record}(c.program, c.caller, c.caller_line);
    return c;
}

Event read_event(const std::byte* record) {
    Event e;
    Fields{record}(e.before, e.value, e.line, e.chain, e.state, e.text, e.axes, e.pass, e.kind);
    return e;
}

Tool read_tool(const std::byte* record) {
    Tool t;
    Fields{record}(t.x, t.z, t.nose, t.wear_x, t.wear_z, t.insert_angle, t.insert_width, t.cutting_angle, t.tool,
                   t.offset, t.family, t.pocket, t.tip);
    return t;
}

void read_move(const std::byte* record, bool wide, Move& m) {
    double p = 0, q = 0;
    std::uint8_t kind = 0, flags = 0;
    const std::byte* body = record + (wide ? sizeof(Position) : 2 * sizeof(double));
    Fields{body}(p, q, m.feed, m.line, m.chain, m.state, m.pass, kind, flags);
    if (wide) {
        m.end = read_position(record);
        Fields{body + 40}(m.moved, m.plane_u, m.plane_v);
    } else {
        m.end[axis_x] = load<double>(record);
        m.end[axis_z] = load<double>(record + sizeof(double));
        m.moved = 0;
        m.plane_u = axis_z;
        m.plane_v = axis_x;
    }
    m.kind = static_cast<Kind>(kind);
    m.full_turn = flags & 1;
    const bool arc = m.kind == Kind::clockwise || m.kind == Kind::counter_clockwise, thread = m.kind == Kind::thread;
    m.centre_v = arc ? p : 0;
    m.centre_u = arc ? q : 0;
    m.lead = thread ? p : 0;
    m.start_angle = thread ? q : 0;
    m.seconds = m.kind == Kind::dwell ? p : 0;
}

}  // namespace fagorc::player
