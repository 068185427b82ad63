// The keys of the tables that have a row each: [axes.X], [[offset]], [[tool]], [[m]].
#include "frontend/machine/key.hpp"

namespace fagorc::frontend::machine_file {
namespace {

using enum Kind;
using machine::AxisData;
using machine::Misc;
using machine::Offset;
using machine::Tool;

constexpr std::string_view axis_types[] = {"linear", "rotary", "positioning", "hirth"};
constexpr control::Range not_negative{.least = 0};

constexpr Key axis[] = {
    {"type", choice, into<&AxisData::type>, {}, {}, axis_types},
    {"AXISTYPE", choice, into<&AxisData::type>, {}, {}, axis_types},
    {"rollover", boolean, into<&AxisData::rollover>},
    {"min", number, into<&AxisData::min>, {}, Measure::axis_length},
    {"LIMIT-", number, into<&AxisData::min>, {}, Measure::axis_length},
    {"max", number, into<&AxisData::max>, {}, Measure::axis_length},
    {"LIMIT+", number, into<&AxisData::max>, {}, Measure::axis_length},
    {"rapid", number, into<&AxisData::rapid>, not_negative, Measure::axis_length},
    {"G00FEED", number, into<&AxisData::rapid>, not_negative, Measure::axis_length},
    {"max_feed", number, into<&AxisData::max_feed>, not_negative, Measure::axis_length},
    {"MAXFEED", number, into<&AxisData::max_feed>, not_negative, Measure::axis_length},
    {"reference", number, into<&AxisData::reference>, {}, Measure::axis_length},
    {"REFVALUE", number, into<&AxisData::reference>, {}, Measure::axis_length},
    {"acceleration", number, into<&AxisData::acceleration>, not_negative, Measure::axis_length},
    {"jerk", number, into<&AxisData::jerk>, not_negative, Measure::axis_length},
};

constexpr Key offset[] = {
    {"X", number, into<&Offset::x>, {}, Measure::length},
    {"Z", number, into<&Offset::z>, {}, Measure::length},
    {"R", number, into<&Offset::nose>, {.least = 0, .most = 1000}, Measure::length},
    {"F", whole, into<&Offset::tip>, {.least = 0, .most = 9}},
    {"I", number, into<&Offset::wear_x>, {}, Measure::length},
    {"K", number, into<&Offset::wear_z>, {}, Measure::length},
};

constexpr Key tool[] = {
    {"offset", whole, into<&Tool::offset>, {.least = 0, .most = 255}},
    {"family", whole, into<&Tool::family>, {.least = 0, .most = 255}},
    {"pocket", whole, into<&Tool::pocket>, {.least = 1, .most = 255}},
    {"NOSEA", number, into<&Tool::insert_angle>, {.least = 0, .most = 360}},
    {"NOSEW", number, into<&Tool::insert_width>, not_negative, Measure::length},
    {"CUTA", number, into<&Tool::cutting_angle>, {.least = 0, .most = 360}},
};

constexpr Key misc[] = {
    {"subroutine", whole, into_unless_zero<&Misc::subroutine>, {.least = 0, .most = 9999}},
    {"before", boolean, into<&Misc::before>},
    {"stops", boolean, into<&Misc::stops>},
    {"m_after_subroutine", boolean, into<&Misc::m_after_subroutine>},
    {"waits_aux_end", boolean, into<&Misc::waits_aux_end>},
};

}  // namespace

std::span<const Key> axis_keys() {
    return axis;
}
std::span<const Key> offset_keys() {
    return offset;
}
std::span<const Key> tool_keys() {
    return tool;
}
std::span<const Key> misc_keys() {
    return misc;
}

}  // namespace fagorc::frontend::machine_file
