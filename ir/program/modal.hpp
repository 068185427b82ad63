// The modal state of a control, in neutral terms (8055 T 5.1: one field a modal group).
#pragma once

#include <cstdint>

#include "ir/base/axis.hpp"

namespace fagorc::program {

/// The modal groups. A G code of a group replaces the setting of its group.
enum class Group : std::uint8_t {
    none, motion, plane, distance, unit, diameter, feed, speed, spindle, corner, compensation,
    origin, shift, count_
};

enum class Motion : std::uint8_t { rapid, line, cw, ccw, thread, variable_thread };
enum class PlaneCode : std::uint8_t { xy, zx, yz, by_axes };        ///< G17 G18 G19 G16
enum class Distance : std::uint8_t { absolute, incremental };
enum class LengthUnit : std::uint8_t { mm, inch };
enum class XWord : std::uint8_t { diameter, radius };               ///< G151 G152
enum class FeedMode : std::uint8_t { per_minute, per_revolution, inverse_time };
enum class SpeedMode : std::uint8_t { rpm, constant_surface };      ///< G97 G96
enum class Spindle : std::uint8_t { main, second };
enum class Corner : std::uint8_t { round, square, controlled, look_ahead };  ///< G05 G07 G50 G51
enum class Side : std::uint8_t { off, left, right };                ///< G40 G41 G42

/// Settings of the groups. A block changes them before any of its words is interpreted (docs/order.md, step 4).
struct Modal {
    Motion motion = Motion::rapid;
    PlaneCode plane_code = PlaneCode::zx;
    Plane plane = plane_g18;
    Distance distance = Distance::absolute;
    LengthUnit unit = LengthUnit::mm;
    XWord x = XWord::diameter;
    FeedMode feed = FeedMode::per_minute;
    SpeedMode speed = SpeedMode::rpm;
    Spindle spindle = Spindle::main;
    Corner corner = Corner::round;
    Side side = Side::off;
    friend bool operator==(const Modal&, const Modal&) = default;
};

}  // namespace fagorc::program
