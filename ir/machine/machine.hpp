// The machine that a program is executed on: axes, tables, power-on state, policies (docs/machine-file.md).
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "ir/base/axis.hpp"
#include "ir/program/modal.hpp"

namespace fagorc::machine {

enum class AxisType : std::uint8_t { linear, rotary, positioning, hirth };

/// One axis. Limits in machine coordinates, mm (X as a radius) or degrees; feeds in mm/min or degrees/min.
struct AxisData {
    bool exists = false;
    AxisType type = AxisType::linear;
    bool rollover = false;
    std::optional<double> min, max;
    double rapid = 10000, max_feed = 10000;
    double reference = 0;                         ///< machine coordinate of the home point (REFVALUE)
    std::optional<double> acceleration, jerk;     ///< mm/s2, mm/s3
};

/// A row of the offset table (8055 T 8.1). Lengths in mm, X as a radius; wear I as a diameter by policy.
struct Offset {
    double x = 0, z = 0;
    double nose = 0;                 ///< R
    std::uint8_t tip = 0;            ///< location code F 0..9
    double wear_x = 0, wear_z = 0;   ///< I, K
};

/// A row of the tool table.
struct Tool {
    std::uint16_t offset = 0;        ///< D that T alone selects
    std::uint16_t family = 0;
    std::optional<std::uint16_t> pocket;
    double insert_angle = 0, insert_width = 0, cutting_angle = 0;   ///< NOSEA degrees, NOSEW mm, CUTA degrees
};

/// A row of the M table (8055 T 5.7).
struct Misc {
    std::optional<std::uint32_t> subroutine;
    bool before = true;              ///< before the motion of its block
    bool stops = false;              ///< stops block preparation
    bool m_after_subroutine = true;  ///< the M itself is sent after the subroutine
    bool waits_aux_end = true;
};

/// What the manuals leave open, by name; docs/machine-file.md lists the choices.
struct Policies {
    int compmode = 0, comptype = 0;
    enum class WearX : std::uint8_t { diameter, radius } wear_x = WearX::diameter;
    enum class ThreadLead : std::uint8_t { path, major_axis } thread_lead = ThreadLead::path;
    enum class OverLimit : std::uint8_t { error, clamp } s_over_limit = OverLimit::error;
};

/// Everything that changes the meaning of a program. A default-constructed machine has nothing; `built_in_lathe`
/// of frontend/machine is the one that is used without a machine file.
struct Machine {
    std::string control;             ///< name of the dialect of programs that do not say theirs
    PerAxis<AxisData> axes{};
    program::Modal power_on;
    program::LengthUnit inches_parameter = program::LengthUnit::mm;   ///< INCHES: unit of G53 words
    PerAxis<double> start{};         ///< tool tip at the first block, machine coordinates, mm, X as a radius
    std::uint16_t start_tool = 0, start_offset = 0;
    std::optional<double> spindle_max_rpm;
    std::map<std::uint16_t, Offset> offsets;
    std::map<std::uint16_t, Tool> tools;
    std::uint16_t tool_count = 0, offset_count = 255;   ///< highest T and D (NTOFFSET)
    Offset default_offset;           ///< rows 1..offset_count that the file does not list
    Tool default_tool;
    bool tool_takes_own_offset = true;   ///< T n without a row takes D n
    std::map<std::uint16_t, Misc> misc;
    std::map<int, PerAxis<double>> origins;   ///< zero-offset rows 1..20 (G54 = 1 .. G59 = 6), mm, X as a radius
    std::map<std::uint32_t, double> parameters;   ///< start values of P
    std::optional<std::uint32_t> tool_subroutine, home_subroutine;    ///< TOOLSUB, REFPSUB
    std::array<std::uint32_t, 4> interrupt_subroutines{};             ///< INT1SUB..INT4SUB, 0 = none
    double arc_tolerance = 0.01;     ///< CIRINERR, mm
    bool polar_origin_follows_arcs = false;   ///< PORGMOVE
    bool feed_zero_is_error = false; ///< FEEDTYPE not 0
    bool tool_needs_m06 = false;     ///< TOFFM06
    bool second_spindle = true, live_tool = true, inclined_axis = true, automatic_gears = false;
    bool compensation_in_all_planes = true;   ///< PLACOMP
    bool c_axis_kept_after_end = false;       ///< PERCAX
    double live_tool_max_rpm = 6000;          ///< MAXSPEED of the auxiliary spindle
    Axis inclined = Axis::X, orthogonal = Axis::Z;   ///< ANGAXNA, ORTAXNA of G46 (8055 T 13)
    double inclined_angle = 30;               ///< degrees from the inclined axis's normal position towards +orthogonal
    int free_analog_outputs = 4;     ///< ANAO1 .. ANAOn; the others drive axes and spindles
    int m19_type = 1;
    std::array<double, 4> gear_rpm{6000, 6000, 6000, 6000};   ///< MAXGEAR1..4
    std::map<std::string, double, std::less<>> other_parameters;   ///< machine parameters that only variables read
    Policies policy;
    std::string source;              ///< file that it comes from; empty: the built-in lathe
};

}  // namespace fagorc::machine
