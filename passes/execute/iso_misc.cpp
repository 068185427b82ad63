// M functions by the machine's table: before or after the motion, with their subroutines (8055 T 5.7).
#include <fmt/format.h>

#include <algorithm>

#include "passes/execute/iso_control.hpp"

namespace fagorc::passes {

using control::Construct;
using operation::Event;
using operation::SpindleTurn;
using program::FunctionCall;

namespace {

/// Stops and ends come after the motion where the machine's table does not say otherwise (8055 T 5.7).
bool ends_its_block(const program::Function& f) {
    const auto* spindle = std::get_if<program::SpindleCommand>(&f);
    return std::holds_alternative<program::ProgramEnd>(f) || std::holds_alternative<program::ProgramStop>(f) ||
           (spindle != nullptr && spindle->turn == program::SpindleCommand::Turn::stop);
}

/// M19 and M45 have events of their own.
bool tells_itself(const program::Function& f) {
    return std::holds_alternative<program::OrientedStop>(f) || std::holds_alternative<program::LiveTool>(f);
}

}  // namespace

void IsoRunner::Control::misc(const program::IsoBlock& block, bool before) {
    for (const FunctionCall& call : block.misc) {
        if (session.ends()) return;
        one_misc(block, call, before);
    }
    for (const program::Word& word : block.misc_by_parameter) {
        if (session.ends()) return;
        misc_by_parameter(block, word, before);
    }
}

void IsoRunner::Control::misc_by_parameter(const program::IsoBlock& block, const program::Word& word, bool before) {
    const auto value = whole(word);
    if (!value) return;
    if (*value > session.dialect.limits.misc) {
        session.report(diag::Id::unknown_misc, word.token, word.end_token, fmt::format("M{}", *value),
                       session.dialect.limits.misc);
        return;
    }
    FunctionCall call;
    call.number = static_cast<std::uint16_t>(*value);
    call.construct = session.dialect.find('M', call.number);
    call.token = word.token;
    one_misc(block, call, before);
}

void IsoRunner::Control::one_misc(const program::IsoBlock& block, const FunctionCall& call, bool before) {
    const auto table = session.machine.misc.find(call.number);
    const bool known = table != session.machine.misc.end();
    const bool first = known ? table->second.before : !ends_its_block(meaning(call.construct));
    if (first != before || !misc_company(block, call)) return;
    misc_function(call);
    if (session.ends()) return;
    if (known && table->second.subroutine && !in_subroutine_of(call.number)) {
        if (outcome.subroutine) {
            queued_misc = call.number;  // T has one too: this one follows it
        } else {
            call_misc_subroutine(call.number, table->second);
        }
        return;
    }
    if (!tells_itself(meaning(call.construct))) send_misc(call.number);
    if (known && table->second.stops) emit(operation::Barrier{operation::Barrier::Why::preparation});
}

/// An M with a subroutine is alone; T may stand with the tool change (8055 T 5.6, 5.7).
bool IsoRunner::Control::misc_company(const program::IsoBlock& block, const FunctionCall& call) {
    const auto table = session.machine.misc.find(call.number);
    if (table == session.machine.misc.end() || !table->second.subroutine || in_subroutine_of(call.number)) return true;
    const bool change = std::holds_alternative<program::ToolChange>(meaning(call.construct));
    const bool others = block.geometry.count != 0 || block.feed || block.speed || !block.modal.empty() ||
                        !block.functions.empty() || block.misc.size() + block.misc_by_parameter.size() > 1;
    if (!others && (change || !(block.tool || block.offset))) return true;
    session.report(diag::Id::must_be_alone, call.token, call.token + 1u, fmt::format("M{}", call.number));
    return false;
}

/// What an M function changes in the control; it is sent to the machine afterwards.
void IsoRunner::Control::misc_function(const FunctionCall& call) {
    program::Function function = meaning(call.construct);
    if (call.construct != nullptr && !call.construct->operands.empty()) {
        const auto with_words = filled(call);
        if (!with_words) return;
        function = *with_words;
    }
    if (const auto* spindle = std::get_if<program::SpindleCommand>(&function)) {
        using Turn = program::SpindleCommand::Turn;
        state.turn = spindle->turn == Turn::stop        ? SpindleTurn::stopped
                     : spindle->turn == Turn::clockwise ? SpindleTurn::clockwise
                                                        : SpindleTurn::counter_clockwise;
        state_changed();
    } else if (const auto* gear = std::get_if<program::SpindleGear>(&function)) {
        state.gear = static_cast<std::uint8_t>(gear->gear);
        state_changed();
    } else if (const auto* stop = std::get_if<program::OrientedStop>(&function)) {
        state.turn = SpindleTurn::oriented;
        oriented_angle = stop->angle.value_or(0);  // without S at the marker pulse
        state_changed();
        emit_event(Event::Kind::spindle_angle, oriented_angle);
    } else if (const auto* live = std::get_if<program::LiveTool>(&function)) {
        if (!session.machine.live_tool) {
            session.report(diag::Id::no_live_tool, call.token, call.token + 1u, call.construct->code);
            return;
        }
        live_tool_speed = live->speed.value_or(0);
        emit_event(Event::Kind::live_tool, live_tool_speed);
    } else if (std::holds_alternative<program::ToolChange>(function) && next_tool) {
        select_tool(next_tool->tool);
        select_offset(next_tool->offset);
        next_tool.reset();
        emit_event(Event::Kind::tool, state.tool);
        emit_event(Event::Kind::offset, state.offset);
    } else if (std::holds_alternative<program::ProgramEnd>(function)) {
        outcome.program_end = true;
    }
}

void IsoRunner::Control::send_misc(std::uint16_t number) {
    sent.insert(number);
    emit_event(Event::Kind::misc, number);
}

void IsoRunner::Control::call_misc_subroutine(std::uint16_t number, const machine::Misc& row) {
    if (!row.m_after_subroutine) send_misc(number);
    waiting.push_back({Waiting::For::misc, number, row.m_after_subroutine});
    outcome.subroutine = row.subroutine;
}

bool IsoRunner::Control::in_subroutine_of(std::uint16_t number) const {
    return std::any_of(waiting.begin(), waiting.end(),
                       [&](const Waiting& w) { return w.what == Waiting::For::misc && w.number == number; });
}

bool IsoRunner::Control::in_tool_subroutine() const {
    return std::any_of(waiting.begin(), waiting.end(), [](const Waiting& w) { return w.what == Waiting::For::tool; });
}

const Construct* IsoRunner::Control::gear_row(int gear) const {
    for (const Construct* c : session.dialect.constructs) {
        if (c->letter != 'M') continue;
        const program::Function f = meaning(c);
        if (const auto* g = std::get_if<program::SpindleGear>(&f); g != nullptr && g->gear == gear) return c;
    }
    return nullptr;
}

}  // namespace fagorc::passes
