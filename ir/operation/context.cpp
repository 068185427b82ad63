#include "ir/operation/context.hpp"

namespace fagorc::operation {
namespace {

/// Mixes the hash of one more field into `seed`.
template <class T>
void mix(std::size_t& seed, const T& value) {
    seed ^= std::hash<T>{}(value) + 0x9e3779b97f4a7c15ULL + (seed << 6) + (seed >> 2);
}

}  // namespace

std::size_t StateHash::operator()(const State& s) const {
    std::size_t h = 0;
    const auto& m = s.modal;
    for (unsigned field : {unsigned(m.motion), unsigned(m.plane_code), unsigned(m.plane.u) * 16 + unsigned(m.plane.v),
                           unsigned(m.distance), unsigned(m.unit), unsigned(m.x), unsigned(m.feed), unsigned(m.speed),
                           unsigned(m.spindle), unsigned(m.corner), unsigned(m.side), unsigned(s.tool), unsigned(s.offset),
                           unsigned(s.gear), unsigned(s.tip), unsigned(s.turn),
                           unsigned(s.stop_disabled) * 4 + unsigned(s.feed_hold_disabled) * 2 + unsigned(s.single_block_joined)})
        mix(h, field);
    for (double field : {s.nose, s.length_x, s.length_z, s.speed_limit, s.look_ahead.acceleration, s.look_ahead.error,
                         s.look_ahead.corner_angle})
        mix(h, field);
    return h;
}

std::size_t FrameHash::operator()(const Frame& f) const {
    std::size_t h = f.machine;
    for (double o : f.offset) mix(h, o);
    return h;
}

std::size_t ChainHash::operator()(const Chain& c) const {
    std::size_t h = static_cast<std::size_t>(c.program);
    mix(h, static_cast<std::uint32_t>(c.caller));
    mix(h, c.caller_line);
    return h;
}

}  // namespace fagorc::operation
