// Canned cycles as neutral operations: one struct a kind of cycle, whatever letters a control spells it with, and the
// differences between controls as fields. u is the abscissa (Z of a lathe), v the ordinate (X) of the active plane.
// Lengths in millimetres, along v as radii; points in programmed coordinates; angles in degrees; times in 1/100 s; feeds
// in the unit of the call. An operand left out is empty: it is not the same as 0 (8055 T 9.2: D).
#pragma once

#include <cstdint>
#include <optional>

namespace fagorc::operation {

using Value = std::optional<double>;

/// Along which axis a cycle cuts; its levels, plunges or depths lie along the other one.
enum class Cut : std::uint8_t { along_u, along_v };

/// How the stock is divided: passes of the step, the last takes the rest; or equal passes not larger than the step.
enum class PassPlan : std::uint8_t { constant, at_most };

/// How the finishing allowance moves a contour: along its normal, or as a whole by the two allowances.
enum class Allowance : std::uint8_t { normal, displaced };

/// Where the last level of a stock removal lies: at the depth of the profile's start, or the allowance above it.
enum class LastLevel : std::uint8_t { start, allowance };

/// What a cycle leaves behind: the G functions and F of the call; the same without radius compensation; or rapid,
/// absolute, uncompensated with the last feed used.
enum class Leaves : std::uint8_t { call_state, uncompensated, rapid_absolute };

/// Roughing by copies of a profile (8055 T 9.1 G66).
struct ContourRepeat {
    PassPlan plan = PassPlan::constant;
    Leaves leaves = Leaves::rapid_absolute;
    Value start_u, start_v;          ///< first point of the profile
    Value stock;                     ///< stock to remove, along the axis of `main_axis`
    Value step;                      ///< pass, along the same axis
    Value main_axis;                 ///< 0: stock and step along v, 1: along u; none: by the longer tool dimension
    Value allowance_v, allowance_u;  ///< finishing stock; the sign selects the corner mode; no u: equidistant passes
    Value finishing_feed;            ///< 0 or none: no finishing pass
    Value first_label, last_label, program;   ///< where the profile stands; no program: the calling one
    Value segment;                   ///< length of a segment roughed to full depth before the next
};

/// Stock removal down to a profile, valleys included (8055 T 9.2 G68, 9.3 G69).
struct StockRemoval {
    Cut cut = Cut::along_u;
    PassPlan plan = PassPlan::constant;
    Allowance allowance = Allowance::normal;
    LastLevel last_level = LastLevel::start;
    Leaves leaves = Leaves::rapid_absolute;
    Value start_u, start_v;          ///< first point of the profile
    Value step;                      ///< depth of a pass
    Value retreat;                   ///< none: leave along the contour, 0: back on the way in, else at 45 degrees
    Value allowance_v, allowance_u;  ///< finishing stock; the sign selects the corner mode; no u: that of v all along
    Value valley_feed;               ///< penetration in valleys; 0 or none: the active feed
    Value roughing_feed;             ///< feed of the last roughing pass along the contour; 0 or none: no such pass
    Value finishing_feed;            ///< 0 or none: no finishing pass
    Value first_label, last_label, program;   ///< where the profile stands; no program: the calling one
    Value segment;                   ///< length of a segment roughed to full depth before the next
};

/// Turning or facing down to one line or one arc (8055 T 9.4 G81, 9.5 G82, 9.7 G84, 9.8 G85).
struct Turning {
    Cut cut = Cut::along_u;
    PassPlan plan = PassPlan::at_most;
    Leaves leaves = Leaves::call_state;
    Value start_u, start_v, end_u, end_v;     ///< the section
    Value centre_u, centre_v;        ///< centre of an arc, from its start; none: a straight section
    Value step;                      ///< depth of a pass
    Value retreat;                   ///< as in StockRemoval
    Value allowance_v, allowance_u;  ///< finishing stock
    Value roughing_feed;             ///< feed of the last roughing pass; 0 or none: no such pass
    Value finishing_feed;            ///< 0 or none: no finishing pass
};

/// Drilling in pecks, or tapping, along u (8055 T 9.6 G83).
struct PeckDrilling {
    PassPlan plan = PassPlan::constant;
    Leaves leaves = Leaves::uncompensated;
    Value start_u, start_v;          ///< point on the surface
    Value depth;                     ///< from the surface, positive against u
    Value peck;                      ///< 0: tapping
    Value approach;                  ///< how far before the surface the tool waits
    Value dwell;                     ///< at the bottom
    Value lift;                      ///< retreat after a peck; 0 or none: to the approach point
    Value clearance;                 ///< rapid stops this far before the last depth; none: 1 mm
    Value least_peck;
    Value factor;                    ///< of a peck to the one before; tapping: 0 floating holder, 1 and 2 rigid
};

/// Longitudinal or face thread in passes (8055 T 9.9 G86, 9.10 G87).
struct Threading {
    Cut cut = Cut::along_u;
    Leaves leaves = Leaves::uncompensated;
    Value start_u, start_v, end_u, end_v;     ///< on the surface
    Value repair;                    ///< coordinate along the thread at which a groove was measured
    Value depth;                     ///< signed: towards the part
    Value infeed;                    ///< first infeed, positive: by the square root of the pass; negative: constant
    Value least_infeed;
    Value approach;                  ///< safety distance; the sign selects the corner mode of the return
    Value allowance;                 ///< finishing stock; positive: infeed at the angle, negative: radial, 0: repeat
    Value lead;                      ///< positive along the surface, negative along the axis of the thread
    Value exit;                      ///< length of the exit; positive to the safety line, negative to the surface
    Value infeed_angle;              ///< to the axis of the depth; 0 radial, negative zigzag; none: 30 degrees
    Value start_angle;               ///< spindle angle of the start, or of the groove of `repair`
    Value starts;
    Value lead_change;               ///< of each turn
    Value entry;                     ///< 0 radial, 1 first flank, 2 radial zigzag, 3 last flank, 4, 5 zigzags
    Value partial;                   ///< 1: in and out along the thread
};

/// Grooving in plunges (8055 T 9.11 G88, 9.12 G89).
struct Grooving {
    Cut cut = Cut::along_v;          ///< of the plunges
    Leaves leaves = Leaves::uncompensated;
    Value start_u, start_v, end_u, end_v;     ///< corner on the surface, opposite corner at the bottom
    Value step;                      ///< between plunges; none: the insert's width
    Value clearance;                 ///< safety distance from the surface
    Value dwell;                     ///< after each plunge
};

/// Holes at several spindle angles with a driven tool (8055 T 9.13 G60 on the face, 9.14 G61 on the turned surface).
struct LiveDrilling {
    Cut cut = Cut::along_u;          ///< axis of the holes
    Leaves leaves = Leaves::uncompensated;
    Value start_u, start_v;          ///< point on the surface
    Value depth;                     ///< from the surface, positive against the axis
    Value peck;                      ///< 0: tapping
    Value first_angle, angle_step, count;     ///< spindle angles
    Value approach, dwell, lift, clearance, least_peck, factor;   ///< as in PeckDrilling
    Value tool_speed;                ///< rpm, the sign is the sense
};

/// Keyways at several spindle angles with a driven tool (8055 T 9.15 G62 on the turned surface, 9.16 G63 on the face).
struct Keyway {
    Cut cut = Cut::along_u;          ///< axis of the keyway
    Leaves leaves = Leaves::uncompensated;
    Value start_u, start_v;          ///< point on the surface
    Value length;                    ///< positive against the axis
    Value depth;                     ///< from the surface, positive against the other axis
    Value first_angle, angle_step, count;     ///< spindle angles
    Value approach;                  ///< safety distance from the surface
    Value feed;                      ///< along the keyway; none: the active feed
    Value tool_speed;                ///< rpm, the sign is the sense
};

}  // namespace fagorc::operation
