// What the control keeps from one ISO block to the next, and what a block at hand has said so far.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <set>
#include <vector>

#include "ir/control/construct.hpp"
#include "ir/operation/operation.hpp"
#include "passes/execute/iso_forms.hpp"
#include "passes/execute/zero_offsets.hpp"

namespace fagorc::passes {

struct IsoState {
    // -- modal state
    operation::State state;
    std::array<std::optional<operation::StateId>, 6> state_ids;  ///< of `state` by motion mode: G0 and G1 alternate
    const control::Construct* motion_row = nullptr;              ///< row of the motion mode in force
    ZeroOffsets offsets;
    PolarFrame polar;
    PathEnd path;
    std::uint64_t block_count = 0;

    // -- position: now.others holds the tip of every axis in part coordinates, also of the plane's
    operation::Operation now;      ///< the operation to come; fields change in place
    PerAxis<double> programmed{};  ///< from where increments count (8055 T 3.4)
    PerAxis<double> target{};      ///< of the words of the block at hand

    // -- F and S by their modes; feeds in mm/min, mm/rev, 1/min, speeds in rpm, m/min
    std::array<double, 3> feeds{};
    std::array<std::optional<double>, 2> speeds;
    bool cutting_checked = false;  ///< F and S suffice for a move at the feed
    struct NextTool {
        std::uint16_t tool = 0, offset = 0;
    };
    std::optional<NextTool> next_tool;  ///< T that waits for M06
    double oriented_angle = 0;          ///< of the last M19
    double live_tool_speed = 0;         ///< of the last M45
    std::set<std::uint16_t> sent;       ///< M functions without a meaning of their own that were sent (MSn)

    // -- of the block at hand
    BlockForm form;
    bool form_used = false;  ///< `form` says something: it is cleared before the next block
    /// What has called a subroutine that runs, innermost last; an M is sent at its end where `send` says so.
    struct Waiting {
        enum class For : std::uint8_t { misc, tool, home } what = For::misc;
        std::uint16_t number = 0;
        bool send = false;
    };
    std::vector<Waiting> waiting;
    std::optional<std::uint16_t> queued_misc;  ///< its subroutine follows the tool's

    // -- conversion, from the modal state
    double unit = 1;  ///< mm of a length unit
    double word_limit = 1e5;
    std::uint8_t most_decimals = 4;
    PerAxis<double> scale{};  ///< mm, X as a radius, or degrees of one unit of an axis word
    PerAxis<AxisWay> way{};
    AxisSet hirth_axes, positioning_axes;  ///< that only position; Hirth axes are such too (8055 T 3.7)

    /// The operands of a motion code by letter, looked up once.
    struct Spelling {
        const control::Construct* row = nullptr;
        std::array<const control::Operand*, 26> operands{};
    };
    std::array<Spelling, 6> spellings;  ///< by motion mode

    /// Something in the state other than the motion mode has changed.
    void state_changed() { state_ids.fill(std::nullopt); }
    Point plane_point() const { return {now.others[state.modal.plane.u], now.others[state.modal.plane.v]}; }
    /// The tool's length along an axis: machine reference = tip + length (8055 T 8.1).
    double tool_length(Axis axis) const {
        return axis == Axis::X ? state.length_x : axis == Axis::Z ? state.length_z : 0;
    }
    void path_ends(Point direction) {
        path.direction = direction;
        path.plane = state.modal.plane;
        path.block = block_count;
        path.known = true;
    }
    std::string_view code_of_motion() const { return motion_row ? motion_row->code : std::string_view(); }
};

}  // namespace fagorc::passes
