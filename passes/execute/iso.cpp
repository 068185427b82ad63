#include "passes/execute/iso.hpp"

#include <utility>

#include "passes/execute/iso_control.hpp"

namespace fagorc::passes {

using program::IsoBlock;

IsoRunner::IsoRunner(Session& session) : control_(std::make_unique<Control>(session)) {}
IsoRunner::~IsoRunner() = default;

IsoRunner::Outcome IsoRunner::run(const IsoBlock& block) {
    return control_->run(block);
}
std::optional<std::uint32_t> IsoRunner::subroutine_ended() {
    return control_->subroutine_ended();
}
void IsoRunner::reset() {
    control_->reset();
}
const program::Modal& IsoRunner::modal() const {
    return control_->state.modal;
}

void IsoRunner::push_event(operation::Event event) {
    control_->now.moved = {};
    control_->emit(event);
}

void IsoRunner::push_barrier(operation::Barrier::Why why) {
    control_->now.moved = {};
    control_->emit(operation::Barrier{why});
}

void IsoRunner::enable(program::Enable what) {
    using What = program::Enable::What;
    operation::State& s = control_->state;
    switch (what.what) {
        case What::single_block:
            s.single_block_joined = what.on;
            break;
        case What::stop:
            s.stop_disabled = !what.on;
            break;
        case What::feed_hold:
            s.feed_hold_disabled = !what.on;
            break;
    }
    control_->state_changed();
}

IsoRunner::Control::Control(Session& s) : session(s) {
    using machine::AxisType;
    for (Axis a : all_axes) {
        const machine::AxisData& data = s.machine.axes[a];
        const bool positions = data.type == AxisType::positioning || data.type == AxisType::hirth;
        if (data.type == AxisType::hirth) hirth_axes.add(a);
        if (positions) positioning_axes.add(a);
        way[a] = !data.exists                    ? AxisWay::missing
                 : is_rotary(a) && data.rollover ? (positions ? AxisWay::shortest : AxisWay::turning)
                 : positions                     ? AxisWay::indexed
                                                 : AxisWay::straight;
    }
    state.gear = 1;
    power_on();
    state.tool = s.machine.start_tool;
    select_offset(s.machine.start_offset);
    now.others = programmed = s.machine.start;  // of the tip, with that tool
    now.at.frame = s.tables.frames.intern({offsets.total(), false});
}

/// Gives each modal group its power-on setting; what survives M30 stays (8055 T 5.1).
void IsoRunner::Control::power_on() {
    state.modal = session.machine.power_on;
    state.turn = operation::SpindleTurn::stopped;
    state.speed_limit = 0;
    state.look_ahead = {};
    state.stop_disabled = state.feed_hold_disabled = state.single_block_joined = false;
    motion_row = row_of(program::Group::motion, static_cast<std::uint8_t>(state.modal.motion));
    polar = {};
    feeds = {};
    speeds = {};
    units_changed();
    technology_changed();
    state_changed();
}

void IsoRunner::Control::reset() {
    power_on();
    state.nose = offset_row(state.offset).nose;  // HTOR ends (8055 T 11.2.2)
    waiting.clear();
    queued_misc.reset();
}

IsoRunner::Outcome IsoRunner::Control::run(const IsoBlock& block) {
    outcome = {};
    ++block_count;
    if (form_used) form = {};
    form_used = false;
    if (!(block.modal.empty() && block.functions.empty()) && !codes(block)) return outcome;
    if (block.tool || block.offset) tool_words(block);
    if (block.feed) set_feed(*block.feed);
    if (block.speed) set_speed(*block.speed);
    if (form.surface != nullptr && !surface_speed_known()) return outcome;
    if (session.ends()) return outcome;
    if (form.dwell) dwell(*form.dwell);
    const bool has_misc = !block.misc.empty() || !block.misc_by_parameter.empty();
    if (has_misc) misc(block, true);
    if (block.speed && !session.ends() && !speed_within_limits(block)) return outcome;
    if (block.geometry.count != 0 && !session.ends()) move(block);
    if (has_misc && !session.ends()) misc(block, false);
    return outcome;
}

std::optional<std::uint32_t> IsoRunner::Control::subroutine_ended() {
    if (waiting.empty()) return std::nullopt;
    const Waiting ended = waiting.back();
    waiting.pop_back();
    if (ended.send) send_misc(ended.number);
    const auto next = std::exchange(queued_misc, std::nullopt);
    if (!next) return std::nullopt;
    call_misc_subroutine(*next, session.machine.misc.at(*next));
    return outcome.subroutine;
}

operation::StateId IsoRunner::Control::state_id() {
    auto& id = state_ids[static_cast<std::size_t>(state.modal.motion)];
    if (!id) id = session.tables.states.intern(state);
    return *id;
}

void IsoRunner::Control::send() {
    if (session.block != nullptr) now.at.line = session.block->here.line;  // null: the end of an empty text
    now.at.chain = session.chain;
    now.at.pass = session.pass;
    now.at.state = state_id();
    if (form.machine == nullptr || !operation::is_motion(now.what)) [[likely]] {
        session.head.push(now);
        return;
    }
    // A move in machine coordinates: its points take the offset that the part zero has (8055 T 4.3).
    operation::Operation there = now;
    const PerAxis<double>& zero = offsets.total();
    const Plane plane = state.modal.plane;
    const Point shift{zero[plane.u], zero[plane.v]};
    for (Axis a : all_axes) there.others[a] += zero[a];
    if (auto* straight = std::get_if<operation::Line>(&there.what)) straight->end = straight->end + shift;
    if (auto* turned = std::get_if<operation::Thread>(&there.what)) turned->end = turned->end + shift;
    if (auto* round = std::get_if<operation::Arc>(&there.what)) {
        round->end = round->end + shift;
        round->centre = round->centre + shift;
    }
    there.at.frame = session.tables.frames.intern({zero, true});
    session.head.push(there);
}

void IsoRunner::Control::emit_event(operation::Event::Kind kind, double value) {
    now.moved = {};
    operation::Event event;
    event.kind = kind;
    event.value = value;
    emit(event);
}

}  // namespace fagorc::passes
