// What an ISO block says about its motion, and what of the last motion the next one may need.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "ir/base/arc.hpp"
#include "ir/base/axis.hpp"
#include "ir/base/geometry.hpp"
#include "ir/control/construct.hpp"
#include "ir/program/statement.hpp"

namespace fagorc::passes {

/// Where the last path of the plane went, for an arc that continues it (8055 T 6.5).
struct PathEnd {
    Point direction;  ///< at its end, of any length but zero
    Plane plane;
    std::uint64_t block = 0;  ///< count of the block that moved
    bool known = false;
};

/// Polar origin in part coordinates, and the polar coordinates of the last point that was given by them (8055 T 3.6.2).
struct PolarFrame {
    Point origin, at;
    double radius = 0, angle = 0;
    bool placed = false;  ///< by G93 or an arc; until then the origin is the part zero, wherever that goes
};

/// What the functions of the block at hand say about its motion.
struct BlockForm {
    enum class Arc : std::uint8_t { by_motion, tangent, three_points } arc = Arc::by_motion;
    bool absolute_centre = false;                    ///< G06
    const control::Construct* arc_row = nullptr;     ///< of G06, G08, G09
    const program::FunctionCall* machine = nullptr;  ///< G53: the coordinates are machine coordinates
    const program::FunctionCall* units = nullptr;    ///< a unit or X mode that was not in force before
    const program::FunctionCall* surface = nullptr;  ///< G96
    std::optional<program::Dwell> dwell;
};

/// What a code of the table does; nothing for one that only the PLC understands.
inline program::Function meaning(const control::Construct* row) {
    return row != nullptr && row->make != nullptr ? row->make() : program::Function{};
}

/// The words of a motion in millimetres and degrees.
struct MotionWords {
    struct Centre {
        double value = 0;
        const program::Word* word = nullptr;
    };
    AxisSet axes;                               ///< axes that have a word; `Control::target` holds where they go
    std::optional<double> radius, angle, lead;  ///< R, Q, L
    int angles = 0;                             ///< how many Q
    std::array<Centre, 4> centres;              ///< I J K in the order written
    std::size_t centre_count = 0;
    const program::Word* polar = nullptr;  ///< the first R or Q, to be marked
};

/// How an axis goes to its coordinate (8055 T 3.7).
enum class AxisWay : std::uint8_t {
    missing,   ///< the machine does not have it
    straight,  ///< to the coordinate: linear, or rotary without rollover
    indexed,   ///< the same for an axis that only positions
    turning,   ///< rotary with rollover: the sign is the sense of rotation
    shortest   ///< positioning-only with rollover: the shortest way
};

/// I J K sorted by what they are, in the programmed unit.
struct CentreWords {
    std::optional<double> u, v;   ///< those of the plane's axes
    std::optional<double> pitch;  ///< of a helix, above zero
};

/// An arc of the plane as its block gives it; `pitch` of a helix of several turns, mm.
struct ArcForm {
    Point end, centre;
    bool ccw = false, full = false;
    std::optional<double> pitch;
};

}  // namespace fagorc::passes
