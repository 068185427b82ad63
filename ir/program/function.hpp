// Functions that a block calls, in neutral terms: what a control word means when its operands have values.
// Lengths in millimetres, X and all lengths as radii, angles in degrees as programmed; the executor has applied the
// active unit and the X word mode by the role of each operand. Positions are programmed (part) coordinates.
#pragma once

#include <cstdint>
#include <optional>
#include <variant>

#include "ir/base/axis.hpp"
#include "ir/operation/cycle.hpp"

namespace fagorc::program {

/// G04: `hundredths` of a second (K1..99999), at the start of its block. K0 or a bare K: stop and take the real
/// position. No K: stop of block preparation (8055 T 7.1).
struct Dwell { std::optional<double> hundredths; };

/// G16: plane of the two axes named (8055 T 3.2).
struct PlaneByAxes { AxisValues axes; };

/// G92: the present position takes the values; or, with S, the highest spindle speed in rpm (8055 T 4.4.1).
struct Preset { AxisValues axes; std::optional<double> speed_limit; };

/// G93: polar origin in programmed coordinates of the plane, both or none (none: the present point) (8055 T 4.5).
struct PolarOrigin { std::optional<double> u, v; };

/// G54..G57, G159: row of the zero-offset table that replaces the absolute offset (8055 T 4.4.2).
struct AbsoluteOrigin { std::optional<double> row; };

/// G58 G59: row that is added to the absolute offset (8055 T 4.4.2).
struct IncrementalOrigin { std::optional<double> row; };

/// G158: incremental offset by values; no axis: cancelled (8055 T 4.4.2).
struct OriginShift { AxisValues axes; };

/// G74: home search of the axes in the order written; none: the control's home subroutine (8055 T 4.2).
struct Home { AxisValues axes; };

/// G53: the words of this block are machine coordinates; without a word the zero offset ends (8055 T 4.3).
struct MachineCoordinates {};

/// G06: I J K of this arc are absolute (8055 T 6.4).
struct AbsoluteCentre {};
/// G08: arc tangent to the path before (8055 T 6.5).
struct TangentArc {};
/// G09: arc through the point I J K (8055 T 6.6).
struct ThreePointArc {};

/// G51: look-ahead; acceleration percent A, contour error E in mm, corner angle B in degrees (8055 T 7.4).
struct LookAhead { std::optional<double> acceleration, error, corner_angle; };

/// G36 G37 G38 G39: corner with its radius R, mm (8055 T 6.8 - 6.11).
struct CornerFunction {
    enum class Kind : std::uint8_t { rounding, entry, exit, chamfer } kind = Kind::rounding;
    std::optional<double> radius;
};

/// G41 G42 N: number of blocks searched for collisions (8055 T 8.3).
struct CompensationSearch { std::optional<double> blocks; };

/// G11..G14: these axes are mirrored too; G10 (`off`): none is (8055 T 7.5).
struct Mirror { AxisValues axes; bool off = false; };

/// G72: general scale S, or one factor an axis (8055 T 7.6).
struct Scale { std::optional<double> general; AxisValues axes; };

/// G15: C axis, on a cylinder of radius R when given (8055 T 6.15).
struct RotaryPlane { std::optional<double> radius; };

/// G20 G21 G22: work zone K; limits in machine coordinates, X as a radius; state S (8055 T 3.8).
struct WorkZone {
    enum class Kind : std::uint8_t { lower, upper, state } kind = Kind::lower;
    std::optional<double> zone, state;
    AxisValues limits;
};

/// G28 G29 with axes: swapped axes; without: the selected spindle (8055 T 5.4, 7.8).
struct AxisSwap { bool undo = false; AxisValues axes; };

/// G77 G78 with axes: coupling; with S (`spindle`): spindle synchronisation (8055 T 5.5, 7.7).
struct Coupling { bool undo = false; bool spindle = false; AxisValues axes; };

/// G30: lag of the synchronised second spindle, degrees (8055 T 5.5).
struct SpindlePhase { std::optional<double> lag; };

/// G45: tangential control of a rotary axis with its angle to the path; no axis: off (8055 T 6.18).
struct TangentialControl { AxisValues axis; };

/// G145: tangential control is suspended (0 or nothing) or resumed (1) (8055 T 6.19).
struct TangentialPause { std::optional<double> resume; };

/// G46: inclined axis (8055 T 13).
struct InclinedAxis { std::optional<double> state; };

/// G52: move to a hard stop (8055 T 6.16).
struct HardStop { AxisValues axes; };

/// G233: withdrawal of an interrupted thread, distances by axis (8055 T 6.13).
struct ThreadWithdrawal { AxisValues axes; };

/// G75 G76: probing move (8055 T 10.1).
struct ProbeMove { bool until_release = false; AxisValues axes; };

/// M00 M01: stop until cycle start; `conditional` by a switch (8055 T 5.7).
struct ProgramStop { bool conditional = false; };

/// M02 M30: end of the program with the general reset (8055 T 5.7).
struct ProgramEnd {};

/// M03 M04 M05: the selected spindle turns or stops (8055 T 5.7).
struct SpindleCommand {
    enum class Turn : std::uint8_t { clockwise, counter_clockwise, stop } turn = Turn::stop;
};

/// M06: the selected tool goes into the spindle (8055 T 5.7.6).
struct ToolChange {};

/// M19: the spindle stops oriented at `angle` degrees from the marker pulse; no angle: at the marker (8055 T 5.7).
struct OrientedStop { std::optional<double> angle; };

/// M41 .. M44: gear of the spindle (8055 T 5.7).
struct SpindleGear { int gear = 1; };

/// M45: live tool at `speed` rpm, the sign is the sense; none or 0: stop (8055 T 5.7).
struct LiveTool { std::optional<double> speed; };

using Function =
    std::variant<std::monostate, Dwell, PlaneByAxes, Preset, PolarOrigin, AbsoluteOrigin, IncrementalOrigin, OriginShift,
                 Home, MachineCoordinates, AbsoluteCentre, TangentArc, ThreePointArc, LookAhead, CornerFunction,
                 CompensationSearch, Mirror, Scale, RotaryPlane, WorkZone, AxisSwap, Coupling, SpindlePhase,
                 TangentialControl, TangentialPause, InclinedAxis, HardStop, ThreadWithdrawal, ProbeMove, ProgramStop, ProgramEnd,
                 SpindleCommand, ToolChange, OrientedStop, SpindleGear, LiveTool,
                 // canned cycles, expanded by passes/cycles
                 operation::ContourRepeat, operation::StockRemoval, operation::Turning, operation::PeckDrilling,
                 operation::Threading, operation::Grooving, operation::LiveDrilling, operation::Keyway>;

}  // namespace fagorc::program
