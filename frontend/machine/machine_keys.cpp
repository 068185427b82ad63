// The keys of [machine], [modal], [spindle], [start] and [policy].
#include <algorithm>
#include <cctype>

#include "frontend/machine/key.hpp"

namespace fagorc::frontend::machine_file {
namespace {

using enum Kind;
using machine::Machine;
using machine::Policies;
using program::Modal;

Machine& machine_of(void* owner) {
    return *static_cast<Machine*>(owner);
}

constexpr std::string_view units[] = {"mm", "inch"};
constexpr std::string_view x_words[] = {"diameter", "radius"};
constexpr std::string_view motions[] = {"G00", "G01"};
constexpr std::string_view planes[] = {"G17", "G18", "G19"};
constexpr std::string_view distances[] = {"G90", "G91"};
constexpr std::string_view feeds[] = {"G94", "G95"};
constexpr std::string_view corners[] = {"G05", "G07", "G50"};
constexpr std::string_view corner_numbers[] = {"G07", "G05", "G50"};  // ICORNER counts from square corners
constexpr std::string_view axes[] = {"X", "Y", "Z", "U", "V", "W", "A", "B", "C"};
constexpr std::string_view wear[] = {"diameter", "radius"};
constexpr std::string_view leads[] = {"path", "major_axis"};
constexpr std::string_view over_limit[] = {"error", "clamp"};

void set_unit(void* owner, double v) {
    machine_of(owner).power_on.unit = static_cast<program::LengthUnit>(v);
    machine_of(owner).inches_parameter = static_cast<program::LengthUnit>(v);
}

/// DFORMAT of X from 4 on means diameters (8055 T 3.5).
void set_dformat(void* owner, double v) {
    machine_of(owner).power_on.x = v >= 4 ? program::XWord::diameter : program::XWord::radius;
}

void set_plane(void* owner, double v) {
    constexpr Plane plane[] = {plane_g17, plane_g18, plane_g19};
    Modal& modal = machine_of(owner).power_on;
    modal.plane_code = static_cast<program::PlaneCode>(v);
    modal.plane = plane[static_cast<std::size_t>(v)];
}

void set_corner_number(void* owner, double v) {
    using enum program::Corner;
    constexpr program::Corner corner[] = {square, round, controlled};
    machine_of(owner).power_on.corner = corner[static_cast<std::size_t>(v)];
}

template <int Gear>
void set_gear(void* owner, double v) {
    machine_of(owner).gear_rpm[Gear] = v;
}
template <int Input>
void set_interrupt(void* owner, double v) {
    machine_of(owner).interrupt_subroutines[Input] = static_cast<std::uint32_t>(v);
}

/// Axis parameters that stand in [machine] count for every axis.
template <double machine::AxisData::*Member>
void set_all_axes(void* owner, double v) {
    for (machine::AxisData& a : machine_of(owner).axes) a.*Member = v;
}

constexpr control::Range positive{.least = 0, .above = true};
constexpr control::Range not_negative{.least = 0};
constexpr control::Range subroutine{.least = 0, .most = 9999, .whole = true};

constexpr auto motion = into<&Machine::power_on, &Modal::motion>;
constexpr auto distance = into<&Machine::power_on, &Modal::distance>;
constexpr auto feed = into<&Machine::power_on, &Modal::feed>;
constexpr auto corner = into<&Machine::power_on, &Modal::corner>;

constexpr Key general[] = {
    {"units", choice, set_unit, {}, {}, units},
    {"INCHES", choice, set_unit, {}, {}, units},
    {"x", choice, into<&Machine::power_on, &Modal::x>, {}, {}, x_words},
    {"DFORMAT", whole, set_dformat, {.least = 0, .most = 7}},
    {"IMOVE", choice, motion, {}, {}, motions},
    {"IPLANE", choice, set_plane, {}, {}, planes},
    {"ISYSTEM", choice, distance, {}, {}, distances},
    {"IFEED", choice, feed, {}, {}, feeds},
    {"ICORNER", choice, set_corner_number, {}, {}, corner_numbers},
    {"G00FEED", number, set_all_axes<&machine::AxisData::rapid>, not_negative, Measure::length},
    {"MAXFEED", number, set_all_axes<&machine::AxisData::max_feed>, not_negative, Measure::length},
    {"CIRINERR", number, into<&Machine::arc_tolerance>, positive, Measure::length},
    {"PORGMOVE", boolean, into<&Machine::polar_origin_follows_arcs>},
    {"PLACOMP", boolean, into<&Machine::compensation_in_all_planes>},
    {"COMPMODE", whole, into<&Machine::policy, &Policies::compmode>, {.least = 0, .most = 2}},
    {"COMPTYPE", whole, into<&Machine::policy, &Policies::comptype>, {.least = 0, .most = 11}},
    {"FEEDTYPE", boolean, into<&Machine::feed_zero_is_error>},
    {"PERCAX", boolean, into<&Machine::c_axis_kept_after_end>},
    {"NTOFFSET", whole, into<&Machine::offset_count>, {.least = 0, .most = 255}},
    {"max_tool", whole, into<&Machine::tool_count>, {.least = 0, .most = 9999}},
    {"TOFFM06", boolean, into<&Machine::tool_needs_m06>},
    {"TOOLSUB", whole, into_unless_zero<&Machine::tool_subroutine>, subroutine},
    {"REFPSUB", whole, into_unless_zero<&Machine::home_subroutine>, subroutine},
    {"INT1SUB", whole, set_interrupt<0>, subroutine},
    {"INT2SUB", whole, set_interrupt<1>, subroutine},
    {"INT3SUB", whole, set_interrupt<2>, subroutine},
    {"INT4SUB", whole, set_interrupt<3>, subroutine},
    {"AUTOGEAR", boolean, into<&Machine::automatic_gears>},
    {"MAXGEAR1", number, set_gear<0>, not_negative},
    {"MAXGEAR2", number, set_gear<1>, not_negative},
    {"MAXGEAR3", number, set_gear<2>, not_negative},
    {"MAXGEAR4", number, set_gear<3>, not_negative},
    {"M19TYPE", whole, into<&Machine::m19_type>, {.least = 0, .most = 1}},
    {"MAXSPEED", number, into<&Machine::live_tool_max_rpm>, not_negative},
    {"second_spindle", boolean, into<&Machine::second_spindle>},
    {"live_tool", boolean, into<&Machine::live_tool>},
    {"inclined_axis", boolean, into<&Machine::inclined_axis>},
    {"ANGAXNA", choice, into<&Machine::inclined>, {}, {}, axes},
    {"ORTAXNA", choice, into<&Machine::orthogonal>, {}, {}, axes},
    {"inclined_angle", number, into<&Machine::inclined_angle>, {.least = -89, .most = 89}},
    {"free_analog_outputs", whole, into<&Machine::free_analog_outputs>, {.least = 0, .most = 8}},
};

constexpr Key modal[] = {
    {"motion", choice, motion, {}, {}, motions},       {"plane", choice, set_plane, {}, {}, planes},
    {"distance", choice, distance, {}, {}, distances}, {"feed", choice, feed, {}, {}, feeds},
    {"corner", choice, corner, {}, {}, corners},
};

constexpr Key spindle[] = {
    {"max_rpm", number, into<&Machine::spindle_max_rpm>, not_negative},
};

constexpr Key start[] = {
    {"tool", whole, into<&Machine::start_tool>, {.least = 0, .most = 9999}},
    {"offset", whole, into<&Machine::start_offset>, {.least = 0, .most = 255}},
};

constexpr Key policies[] = {
    {"compmode", whole, into<&Machine::policy, &Policies::compmode>, {.least = 0, .most = 2}},
    {"comptype", whole, into<&Machine::policy, &Policies::comptype>, {.least = 0, .most = 11}},
    {"wear_x", choice, into<&Machine::policy, &Policies::wear_x>, {}, {}, wear},
    {"thread_lead", choice, into<&Machine::policy, &Policies::thread_lead>, {}, {}, leads},
    {"s_over_limit", choice, into<&Machine::policy, &Policies::s_over_limit>, {}, {}, over_limit},
};

// Parameters that change no program: servo, spindle and transfer data, and ADIMPG, whose bit 10 (G04 K0) the control
// reads itself.
constexpr std::string_view others[] = {
    "ADIMPG",   "MAXFOVR", "RAPIDOVR", "MINSOVR",  "MAXSOVR",  "SOVRSTEP", "MAXVOLT",  "SPDLSTOP", "SPDLOVR",
    "REFEED1",  "REFEED2", "DECINPUT", "REFDIREC", "GEOMTYPE", "NMISCFUN", "INPOSW",   "INPOSW2",  "LOOKATYP",
    "MANTFCON", "IPOTIME", "SMOTIME",  "TYPE",     "PROTOCOL", "EOFCHR",   "GRAPHICS", "MINAENDW", "OPLDECTI",
};

}  // namespace

std::span<const Key> machine_keys() {
    return general;
}
std::span<const Key> modal_keys() {
    return modal;
}
std::span<const Key> spindle_keys() {
    return spindle;
}
std::span<const Key> start_keys() {
    return start;
}
std::span<const Key> policy_keys() {
    return policies;
}
std::span<const std::string_view> other_parameters() {
    return others;
}

bool is_kept_by_name(std::string_view name) {
    if (std::find(std::begin(others), std::end(others), name) != std::end(others)) return true;
    const std::size_t digits = name.find_first_of("0123456789");
    if (digits == std::string_view::npos || digits < 3 || name.size() - digits > 4) return false;
    const auto is_digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
    if (!std::all_of(name.begin() + static_cast<std::ptrdiff_t>(digits), name.end(), is_digit)) return false;
    const std::string_view root = name.substr(0, digits);
    if (root.size() == 3) return root == "MPG" || root == "MPS" || (root.substr(0, 2) == "MP" && axis_of(root[2]));
    return root == "MPSS" || root == "MPAS" || root == "MPLC";
}

bool same_name(std::string_view a, std::string_view b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                      [](char x, char y) { return x == y || (x == '-' && y == '_') || (x == '_' && y == '-'); });
}

}  // namespace fagorc::frontend::machine_file
