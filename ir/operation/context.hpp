// Where an operation comes from and in which state it happens. States, frames and call chains are interned: an operation
// carries handles, never pointers, because a pass may hold it while the executor moves on.
#pragma once

#include <cstdint>
#include <functional>

#include "ir/base/axis.hpp"
#include "ir/base/interned.hpp"
#include "ir/diag/diagnostic.hpp"
#include "ir/program/modal.hpp"

namespace fagorc::operation {

enum class StateId : std::uint32_t {};
enum class FrameId : std::uint32_t {};
enum class ChainId : std::uint32_t {};

enum class SpindleTurn : std::uint8_t { stopped, clockwise, counter_clockwise, oriented };

/// How G51 looks ahead (8055 T 7.4); all 0 while the corner mode is another.
struct LookAhead {
    double acceleration = 0;         ///< percent; 0 = the machine's
    double error = 0;                ///< contour error, mm
    double corner_angle = 0;         ///< corners below it are machined sharp, degrees; 0 = none
    friend bool operator==(const LookAhead&, const LookAhead&) = default;
};

/// What stays the same over many moves. Feed and speed stand in each operation's context, since they may change with
/// every block and would make this table grow.
struct State {
    program::Modal modal;
    std::uint16_t tool = 0;          ///< T
    std::uint16_t offset = 0;        ///< D
    std::uint8_t gear = 1;           ///< M41..M44
    std::uint8_t tip = 0;            ///< location code F of the active offset
    SpindleTurn turn = SpindleTurn::stopped;
    bool stop_disabled = false, feed_hold_disabled = false, single_block_joined = false;   ///< DSTOP, DFHOLD, ESBLK
    double nose = 0;                 ///< nose radius of the active offset, mm
    double length_x = 0, length_z = 0;   ///< tool lengths with wear, mm, X as a radius (8055 T 8.1)
    double speed_limit = 0;          ///< highest spindle speed by program, rpm (G92 S); 0 = none
    LookAhead look_ahead;
    friend bool operator==(const State&, const State&) = default;
};

/// Zero offset in force: machine coordinate = part coordinate + offset (mm, X as a radius; degrees for rotary axes).
/// `machine` marks a G53 block: its points are machine coordinates of the tool tip already, `offset` is what the part
/// zero still is.
struct Frame {
    PerAxis<double> offset{};
    bool machine = false;
    friend bool operator==(const Frame&, const Frame&) = default;
};

/// How a block was reached: the program that holds it, and the block and chain that called it. Chain 0 is the root
/// program itself.
struct Chain {
    diag::FileId program = diag::FileId::none;
    ChainId caller{};
    std::uint32_t caller_line = 0;   ///< 0 for a root
    friend bool operator==(const Chain&, const Chain&) = default;
};

/// Modal state and origin of one operation.
struct Context {
    std::uint32_t line = 0;          ///< physical line of the block that made it, from 1, in the program of the chain
    ChainId chain{};
    StateId state{};
    FrameId frame{};
    double feed = 0;                 ///< mm/min, mm/rev or 1/min by the state's feed mode; 0 = the highest feed
    double speed = 0;                ///< rpm, or m/min under constant surface speed
    std::uint16_t pass = 0;          ///< run of a repeated block or pass of a cycle, from 0
};

struct StateHash { std::size_t operator()(const State&) const; };
struct FrameHash { std::size_t operator()(const Frame&) const; };
struct ChainHash { std::size_t operator()(const Chain&) const; };

/// The tables behind the handles; one set a compilation, shared by executor, passes and backends.
struct Tables {
    Interned<StateId, State, StateHash> states;
    Interned<FrameId, Frame, FrameHash> frames;
    Interned<ChainId, Chain, ChainHash> chains;
};

}  // namespace fagorc::operation
