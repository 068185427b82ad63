// F, S, T and D: feed, spindle speed and its limits, tool and offset (8055 T 5.2 to 5.6, 8.1).
#include <algorithm>
#include <cmath>

#include "passes/execute/iso_control.hpp"

namespace fagorc::passes {

using program::FeedMode;
using program::SpeedMode;
using program::Word;

namespace {

constexpr double metres_per_foot = 0.3048;
constexpr double mm_per_metre = 1000;

}  // namespace

void IsoRunner::Control::technology_changed() {
    const program::Modal& m = state.modal;
    now.at.feed = feeds[static_cast<std::size_t>(m.feed)];
    now.at.speed = speeds[static_cast<std::size_t>(m.speed)].value_or(0);
    cutting_checked = false;
}

void IsoRunner::Control::set_feed(const Word& word) {
    const double v = number(word);
    if (session.ends()) return;
    if (v < 0 || (v == 0 && session.machine.feed_zero_is_error)) {
        session.report(diag::Id::feed_not_positive, word.token, word.end_token, v);
        return;
    }
    const bool inverse = state.modal.feed == FeedMode::inverse_time;
    now.at.feed = feeds[static_cast<std::size_t>(state.modal.feed)] = inverse ? v : v * unit;
    if (v == 0) cutting_checked = false;
}

void IsoRunner::Control::set_speed(const Word& word) {
    const double v = number(word);
    if (session.ends()) return;
    if (v < 0) {
        session.report(diag::Id::negative_not_allowed, word.token, word.end_token, word.address, v);
        return;
    }
    const bool feet = state.modal.speed == SpeedMode::constant_surface && state.modal.unit == program::LengthUnit::inch;
    speeds[static_cast<std::size_t>(state.modal.speed)] = feet ? v * metres_per_foot : v;
    technology_changed();
}

/// G96 takes the S of its block or the last one under G96 (8055 T 5.3).
bool IsoRunner::Control::surface_speed_known() {
    if (speeds[static_cast<std::size_t>(SpeedMode::constant_surface)]) return true;
    session.report(diag::Id::surface_speed_missing, form.surface->token, form.surface->token + 1u);
    return false;
}

/// Checks S against G92 S and the gear, after the gear of the same block is in (8055 T 4.4.1, 5.3, 5.7).
bool IsoRunner::Control::speed_within_limits(const program::IsoBlock& block) {
    const Word& word = *block.speed;
    if (state.modal.speed != SpeedMode::rpm) return true;
    double& speed = *speeds[static_cast<std::size_t>(SpeedMode::rpm)];
    if (state.speed_limit > 0 && speed > state.speed_limit) {
        if (session.machine.policy.s_over_limit == machine::Policies::OverLimit::error) {
            session.report(diag::Id::speed_above_limit, word.token, word.end_token, speed, state.speed_limit);
            return false;
        }
        speed = state.speed_limit;
        technology_changed();
    }
    const auto& gears = session.machine.gear_rpm;
    if (session.machine.automatic_gears && speed > 0) {
        const auto fits = std::find_if(gears.begin(), gears.end(), [&](double rpm) { return speed <= rpm; });
        const auto gear = static_cast<std::uint8_t>(fits - gears.begin() + 1);
        if (fits != gears.end() && gear != state.gear) return change_gear(block, gear);
    }
    const double most =
        std::min(gears[state.gear - 1u], session.machine.spindle_max_rpm.value_or(gears[state.gear - 1u]));
    if (speed > most) {
        session.report(diag::Id::speed_above_gear, word.token, word.end_token, speed, most);
        return false;
    }
    return true;
}

/// The gear that S needs: its M is sent as if it had been programmed (8055 T 5.7).
bool IsoRunner::Control::change_gear(const program::IsoBlock& block, std::uint8_t gear) {
    const control::Construct* row = gear_row(gear);
    if (row == nullptr) return true;
    const auto table = session.machine.misc.find(row->number);
    if (table == session.machine.misc.end() || !table->second.subroutine) {
        state.gear = gear;
        state_changed();
        send_misc(row->number);
        return true;
    }
    const bool more = block.geometry.count != 0 || !block.misc.empty() || block.feed || block.tool || block.offset ||
                      !block.modal.empty() || !block.functions.empty();
    if (more) {
        const Word& s = *block.speed;
        session.report(diag::Id::gear_with_subroutine, s.token, s.end_token, *speeds[0], row->number);
        return false;
    }
    state.gear = gear;
    state_changed();
    call_misc_subroutine(row->number, table->second);
    return true;
}

/// The spindle speed that constant surface speed gives at the present place, rpm (8055 T 5.3).
double IsoRunner::Control::surface_rpm() const {
    const double speed = speeds[static_cast<std::size_t>(SpeedMode::constant_surface)].value_or(0);
    double most = session.machine.gear_rpm[state.gear - 1u];
    if (state.speed_limit > 0) most = std::min(most, state.speed_limit);
    const double diameter = 2 * std::abs(now.others[Axis::X]);
    return diameter > 0 ? std::min(most, mm_per_metre * speed / (std::numbers::pi * diameter)) : speed > 0 ? most : 0;
}

/// F and S for a move at the feed; a move at F0 runs at the highest feed (8055 T 5.2).
bool IsoRunner::Control::cutting_allowed() {
    using program::Motion;
    const program::Modal& m = state.modal;
    const bool thread = m.motion == Motion::thread || m.motion == Motion::variable_thread;
    if ((thread || m.feed == FeedMode::per_revolution) && now.at.speed == 0) {
        const auto* row = thread ? motion_row : row_of(program::Group::feed, static_cast<std::uint8_t>(m.feed));
        session.report_block(diag::Id::speed_missing, row != nullptr ? row->code : code_of_motion());
        return false;
    }
    if (thread) return true;
    if (now.at.feed == 0) {
        const auto* row = row_of(program::Group::feed, static_cast<std::uint8_t>(m.feed));
        const std::string_view mode = row != nullptr ? row->code : std::string_view();
        if (session.machine.feed_zero_is_error) {
            session.report_block(diag::Id::feed_missing, code_of_motion(), mode);
            return false;
        }
        session.report_block(diag::Id::feed_is_highest, mode);
    }
    cutting_checked = true;
    return true;
}

std::optional<std::uint16_t> IsoRunner::Control::offset_of(std::uint16_t tool) const {
    if (tool == 0) return std::uint16_t{0};
    const machine::Machine& m = session.machine;
    if (const auto row = m.tools.find(tool); row != m.tools.end()) return row->second.offset;
    if (tool > m.tool_count) return std::nullopt;
    return m.tool_takes_own_offset ? tool : m.default_tool.offset;
}

/// T takes its offset from the tool table, D another one; both hold for the motion of their block (8055 T 5.6).
void IsoRunner::Control::tool_words(const program::IsoBlock& block) {
    std::optional<std::uint32_t> tool, offset;
    if (block.tool && !(tool = whole(*block.tool))) return;
    if (block.offset && !(offset = whole(*block.offset))) return;
    const bool calls = tool && session.machine.tool_subroutine && !in_tool_subroutine();
    const auto changes = [](const program::FunctionCall& m) {
        return std::holds_alternative<program::ToolChange>(meaning(m.construct));
    };
    if (calls && (block.geometry.count != 0 || block.feed || block.speed || !block.modal.empty() ||
                  !block.functions.empty() || !std::all_of(block.misc.begin(), block.misc.end(), changes))) {
        session.report(diag::Id::tool_with_subroutine, block.tool->token, block.tool->end_token);
        return;
    }
    if (tool) {
        const auto own = offset_of(static_cast<std::uint16_t>(std::min(*tool, 65535u)));
        if (!own) {
            session.report(diag::Id::tool_not_in_table, block.tool->token, block.tool->end_token, *tool);
            return;
        }
        if (!offset) offset = *own;
    }
    if (*offset > session.machine.offset_count) {
        const Word& word = block.offset ? *block.offset : *block.tool;
        session.report(diag::Id::offset_does_not_exist, word.token, word.end_token, *offset);
        return;
    }
    if (tool && session.machine.tool_needs_m06) {
        next_tool = NextTool{static_cast<std::uint16_t>(*tool), static_cast<std::uint16_t>(*offset)};
    } else {
        if (tool) select_tool(static_cast<std::uint16_t>(*tool));
        select_offset(static_cast<std::uint16_t>(*offset));
        if (tool) emit_event(operation::Event::Kind::tool, state.tool);
        emit_event(operation::Event::Kind::offset, state.offset);
    }
    if (calls) {
        outcome.subroutine = session.machine.tool_subroutine;
        waiting.push_back({Waiting::For::tool, static_cast<std::uint16_t>(*tool), false});
    }
}

void IsoRunner::Control::select_tool(std::uint16_t number) {
    state.tool = number;
    state_changed();
}

/// D0 is all zero.
machine::Offset IsoRunner::Control::offset_row(std::uint16_t number) const {
    if (number == 0) return {};
    const auto found = session.machine.offsets.find(number);
    return found != session.machine.offsets.end() ? found->second : session.machine.default_offset;
}

/// A new offset moves nothing: the turret stays, so the tip stands elsewhere (8055 T 8.1).
void IsoRunner::Control::select_offset(std::uint16_t number) {
    const double before_x = state.length_x, before_z = state.length_z;
    const machine::Offset row = offset_row(number);
    const bool diameter = session.machine.policy.wear_x == machine::Policies::WearX::diameter;
    state.offset = number;
    state.length_x = row.x + (diameter ? row.wear_x / 2 : row.wear_x);
    state.length_z = row.z + row.wear_z;
    state.nose = row.nose;
    state.tip = row.tip;
    now.others[Axis::X] += before_x - state.length_x;
    now.others[Axis::Z] += before_z - state.length_z;
    state_changed();
}

}  // namespace fagorc::passes
