#include "backends/table/json_text.hpp"

#include <array>
#include <nlohmann/json.hpp>

namespace fagorc::backends {
namespace {

using Json = nlohmann::ordered_json;

/// The name of an enumerator, from the list of all of them in their order.
template <class E, std::size_t n>
const char* named(E value, const std::array<const char*, n>& names) {
    return names.at(static_cast<std::size_t>(value));
}

std::string latin_1_as_utf_8(std::string_view bytes) {
    std::string out;
    for (char c : bytes) {
        const auto u = static_cast<unsigned char>(c);
        if (u < 0x80) {
            out += c;
        } else {
            out += static_cast<char>(0xC0 | u >> 6);
            out += static_cast<char>(0x80 | (u & 0x3F));
        }
    }
    return out;
}

/// A number as an integer where it is one: 12, not 12.0, as the lines of moves have it.
Json number(double v) {
    const bool whole = v > -1e15 && v < 1e15 && v == static_cast<double>(static_cast<std::int64_t>(v));
    return whole ? Json(static_cast<std::int64_t>(v)) : Json(v);
}

Json axes(const PerAxis<double>& values, const machine::Machine& machine) {
    Json out = Json::object();
    for (Axis a : all_axes)
        if (machine.axes[a].exists || values[a] != 0) out[std::string(1, letter(a))] = number(values[a]);
    return out;
}

void add_modal(Json& out, const program::Modal& m) {
    out["motion"] = named(m.motion, std::array{"rapid", "line", "cw", "ccw", "thread", "variable_thread"});
    out["plane"] = {std::string(1, letter(m.plane.u)), std::string(1, letter(m.plane.v))};
    out["plane_code"] = named(m.plane_code, std::array{"xy", "zx", "yz", "by_axes"});
    out["distance"] = named(m.distance, std::array{"absolute", "incremental"});
    out["unit"] = named(m.unit, std::array{"mm", "inch"});
    out["x"] = named(m.x, std::array{"diameter", "radius"});
    out["feed_unit"] = named(m.feed, std::array{"mm/min", "mm/rev", "1/min"});
    out["speed_unit"] = named(m.speed, std::array{"rpm", "m/min"});
    out["spindle"] = named(m.spindle, std::array{"main", "second"});
    out["corner"] = named(m.corner, std::array{"round", "square", "controlled", "look_ahead"});
    out["side"] = named(m.side, std::array{"off", "left", "right"});
}

}  // namespace

std::string json_string(std::string_view bytes) {
    try {
        return Json(bytes).dump();
    } catch (const Json::type_error&) {  // no UTF-8
        return Json(latin_1_as_utf_8(bytes)).dump();
    }
}

std::string json_header(const Job& job) {
    const machine::Machine& m = job.machine;
    return R"({"type":"header","version":1,"producer":)" + json_string(job.producer) +
           ",\"control\":" + json_string(m.control) + ",\"machine\":" + json_string(base_name(m.source)) +
           R"(,"units":{"length":"mm","x":"radius","angle":"degree","time":"s"},"frame":"machine","start":)" +
           axes(m.start, m).dump() + "}";
}

std::string json_state(const Job& job, std::uint32_t n, const Situation& situation) {
    const operation::State& s = job.tables.states[situation.state];
    const operation::Frame& f = job.tables.frames[situation.frame];
    Json out{{"type", "state"}, {"state", n}};
    add_modal(out, s.modal);
    out["speed"] = number(situation.speed);
    out["speed_limit"] = number(s.speed_limit);
    out["turn"] = named(s.turn, std::array{"stopped", "clockwise", "counter_clockwise", "oriented"});
    out["gear"] = s.gear;
    out["tool"] = s.tool;
    out["offset"] = s.offset;
    out["tip"] = s.tip;
    out["nose"] = number(s.nose);
    out["length"] = {{"X", number(s.length_x)}, {"Z", number(s.length_z)}};
    out["origin"] = axes(f.offset, job.machine);
    out["machine_coordinates"] = f.machine;
    out["look_ahead"] = {{"acceleration", number(s.look_ahead.acceleration)},
                         {"error", number(s.look_ahead.error)},
                         {"corner_angle", number(s.look_ahead.corner_angle)}};
    out["stop_disabled"] = s.stop_disabled;
    out["feed_hold_disabled"] = s.feed_hold_disabled;
    out["blocks_joined"] = s.single_block_joined;
    return out.dump();
}

}  // namespace fagorc::backends
