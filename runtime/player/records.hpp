// What the records of a trajectory file say, as plain values. Millimetres with X as a radius, degrees, seconds; points
// are the tool tip's, counted from the machine zero. Axes are numbered X Y Z U V W A B C from 0.
#pragma once

#include <array>
#include <cstdint>

#include "runtime/player/blocks.hpp"

namespace fagorc::player {

inline constexpr std::size_t axis_count = 9;
inline constexpr std::uint8_t axis_x = 0, axis_z = 2;
inline constexpr std::uint32_t none = 0xffffffff;
using Position = std::array<double, axis_count>;

enum class Kind : std::uint8_t { rapid, line, clockwise, counter_clockwise, thread, dwell };

/// One move. The plane's abscissa points to the right and its ordinate up where a sense of turning is stated.
struct Move {
    std::uint64_t number = 0;
    Kind kind = Kind::rapid;
    bool full_turn = false;  ///< a whole circle, which its end alone does not tell
    Position start{}, end{};
    std::uint8_t plane_u = axis_z, plane_v = axis_x;
    std::uint16_t moved = 0;  ///< bit n: axis n, outside the plane, goes along in proportion to the path
    double centre_u = 0, centre_v = 0;
    double lead = 0, start_angle = 0;  ///< of a thread: mm a spindle turn, degrees
    double seconds = 0;                ///< of a dwell
    double feed = 0;                   ///< in the unit of the state's feed mode; 0 = the highest feed
    std::uint32_t line = 0;            ///< physical line of its block, from 1, in the program of the chain
    std::uint32_t chain = 0, state = 0;
    std::uint16_t pass = 0;  ///< run of a repeated block or pass of a cycle, from 0
};

/// Modal state, tool, origin and spindle of moves; the enumerations are numbered in docs/trajectory-format.md.
struct State {
    Position origin{};  ///< machine coordinate = part coordinate + origin
    double speed = 0, speed_limit = 0;
    double nose = 0, length_x = 0, length_z = 0;
    double acceleration = 0, contour_error = 0, corner_angle = 0;  ///< look-ahead
    std::uint16_t tool = 0, offset = 0;
    std::uint8_t gear = 0, tip = 0, turn = 0;
    bool machine_frame = false, stop_disabled = false, feed_hold_disabled = false, joined_blocks = false;
    std::uint8_t motion = 0, plane_code = 0, plane_u = 0, plane_v = 0, distance = 0, unit = 0, x_word = 0;
    std::uint8_t feed_mode = 0, speed_mode = 0, spindle = 0, corner = 0, side = 0;
};

/// How a block was reached; a root has no caller.
struct Chain {
    std::uint32_t program = none, caller = none, caller_line = 0;
};

/// Something that happens before a move.
struct Event {
    std::uint64_t before = 0;  ///< number of that move; the number of moves for one after the last
    double value = 0;
    std::uint32_t line = 0, chain = 0, state = 0, text = none;
    std::uint16_t axes = 0, pass = 0;
    std::uint8_t kind = 0;
};

/// A row of the tool table at the start: a tool with its offset, or, with tool 0, an offset alone.
struct Tool {
    double x = 0, z = 0, nose = 0, wear_x = 0, wear_z = 0, insert_angle = 0, insert_width = 0, cutting_angle = 0;
    std::uint16_t tool = 0, offset = 0, family = 0, pocket = 0;
    std::uint8_t tip = 0;
};

State read_state(const std::byte* record);
Chain read_chain(const std::byte* record);
Event read_event(const std::byte* record);
Tool read_tool(const std::byte* record);

/// The nine coordinates at an address.
Position read_position(const std::byte* p);
/// Fills all but number and start. A plain move changes X and Z of `move.end` only, so that it must hold the end
/// before.
void read_move(const std::byte* record, bool wide, Move& move);

}  // namespace fagorc::player
