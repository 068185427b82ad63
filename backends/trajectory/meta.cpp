#include "backends/trajectory/meta.hpp"

#include <nlohmann/json.hpp>
#include <set>

namespace fagorc::backends::trajectory {
namespace {

using Json = nlohmann::ordered_json;

std::string_view name(machine::AxisType type) {
    switch (type) {
        case machine::AxisType::linear:
            return "linear";
        case machine::AxisType::rotary:
            return "rotary";
        case machine::AxisType::positioning:
            return "positioning";
        case machine::AxisType::hirth:
            return "hirth";
    }
    return {};
}

Json axes(const machine::Machine& machine) {
    Json all = Json::object();
    for (Axis a : all_axes) {
        const machine::AxisData& axis = machine.axes[a];
        if (!axis.exists) continue;
        Json one{{"type", name(axis.type)}, {"rapid", axis.rapid}, {"max_feed", axis.max_feed}};
        if (axis.min) one["min"] = *axis.min;
        if (axis.max) one["max"] = *axis.max;
        if (axis.acceleration) one["acceleration"] = *axis.acceleration;
        if (axis.jerk) one["jerk"] = *axis.jerk;
        all[std::string(1, letter(a))] = std::move(one);
    }
    return all;
}

Json policies(const machine::Policies& p) {
    using P = machine::Policies;
    return {{"compmode", p.compmode},
            {"comptype", p.comptype},
            {"wear_x", p.wear_x == P::WearX::diameter ? "diameter" : "radius"},
            {"thread_lead", p.thread_lead == P::ThreadLead::path ? "path" : "major_axis"},
            {"s_over_limit", p.s_over_limit == P::OverLimit::error ? "error" : "clamp"}};
}

ToolRecord row_of(const machine::Offset& offset, std::uint16_t number) {
    ToolRecord r;
    r.x = offset.x;
    r.z = offset.z;
    r.nose = offset.nose;
    r.wear_x = offset.wear_x;
    r.wear_z = offset.wear_z;
    r.offset = number;
    r.tip = offset.tip;
    return r;
}

}  // namespace

std::string meta_text(const Job& job) {
    const machine::Machine& machine = job.machine;
    Json start = Json::object();
    for (Axis a : all_axes)
        if (machine.axes[a].exists) start[std::string(1, letter(a))] = machine.start[a];
    Json m{{"name", base_name(machine.source)}, {"axes", axes(machine)}};
    if (machine.spindle_max_rpm) m["spindle_max_rpm"] = *machine.spindle_max_rpm;
    const Json text{
        {"producer", job.producer},
        {"control", machine.control},
        {"units", {{"length", "mm"}, {"x", "radius"}, {"angle", "degree"}, {"time", "s"}}},
        {"machine", std::move(m)},
        {"start", {{"position", std::move(start)}, {"tool", machine.start_tool}, {"offset", machine.start_offset}}},
        {"policies", policies(machine.policy)}};
    // Names come from outside and may hold any bytes: what is no UTF-8 is replaced.
    return text.dump(1, ' ', false, Json::error_handler_t::replace);
}

std::vector<ToolRecord> tool_rows(const machine::Machine& machine) {
    std::vector<ToolRecord> rows;
    std::set<std::uint16_t> taken;
    for (const auto& [number, tool] : machine.tools) {
        const auto offset = machine.offsets.find(tool.offset);
        ToolRecord r = row_of(offset == machine.offsets.end() ? machine.default_offset : offset->second, tool.offset);
        r.tool = number;
        r.family = tool.family;
        r.pocket = tool.pocket.value_or(0xffff);
        r.insert_angle = tool.insert_angle;
        r.insert_width = tool.insert_width;
        r.cutting_angle = tool.cutting_angle;
        rows.push_back(r);
        taken.insert(tool.offset);
    }
    for (const auto& [number, offset] : machine.offsets)
        if (!taken.contains(number)) rows.push_back(row_of(offset, number));
    return rows;
}

}  // namespace fagorc::backends::trajectory
