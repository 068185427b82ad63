// The operation stream: what the control does, as plain values. Points are plane coordinates in millimetres with X as a
// radius, scale S and mirror already applied; rotary axes in degrees.
#pragma once

#include <cstdint>
#include <type_traits>
#include <variant>

#include "ir/base/axis.hpp"
#include "ir/base/geometry.hpp"
#include "ir/operation/context.hpp"
#include "ir/operation/cycle.hpp"

namespace fagorc::operation {

/// Straight move of the plane axes; rapid (G00) or at the feed.
struct Line { Point end; bool rapid = false; };

/// Arc in the plane. `full` marks a whole turn, which end and centre alone cannot tell from no turn.
struct Arc { Point end, centre; bool ccw = false; bool full = false; };

/// Position-slaved straight move: `lead` mm a spindle turn, from spindle angle `angle` degrees (8055 T 6.12).
struct Thread { Point end; double lead = 0, angle = 0; };

struct Dwell { double seconds = 0; };

/// Something that happens at a place of the path and moves no axis.
struct Event {
    enum class Kind : std::uint8_t {
        misc,            ///< M function: value = its number
        spindle_angle,   ///< M19 S: value = degrees
        live_tool,       ///< M45 S: value = rpm with its sense
        tool,            ///< T: value = its number
        offset,          ///< D: value = its number
        message,         ///< MSG: text = index of the text
        error,           ///< ERROR: value = its number
        home,            ///< G74: axes in `axes`
        graphic_zone,    ///< DGWZ
        program_end      ///< M02, M30 or the end of the text
    };
    Kind kind{};
    AxisSet axes;
    std::uint32_t text = 0;          ///< into the event texts, 0 = none
    double value = 0;
};

/// A stop of block preparation: nothing crosses it, look-ahead and compensation end there (8055 T 7.1, 11.2).
struct Barrier {
    enum class Why : std::uint8_t { preparation, live, position } why = Why::preparation;
};

using What = std::variant<Line, Arc, Thread, Dwell, Event, Barrier>;

/// One operation. `others` are the end positions of the axes outside the plane (the plane's own entries are unused);
/// `moved` names those of them that this operation moves, in proportion to its path.
struct Operation {
    Context at;
    PerAxis<double> others{};
    AxisSet moved;
    What what;
};
static_assert(std::is_trivially_copyable_v<Operation>);

constexpr bool is_motion(const What& w) { return w.index() <= 2; }

/// Takes operations one by one.
class Sink {
  public:
    virtual ~Sink() = default;
    virtual void push(const Operation& operation) = 0;
    /// The stream is complete.
    virtual void finish() {}
};

}  // namespace fagorc::operation
