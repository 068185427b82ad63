// What the G codes of a block do: settings of modal groups and the functions that act by themselves
// (docs/order.md, steps 4 and 5).
#include <cmath>
#include <type_traits>

#include "passes/execute/iso_control.hpp"

namespace fagorc::passes {

using control::Construct;
using control::Operand;
using control::Role;
using program::FunctionCall;
using program::Group;
using program::Word;

namespace {

/// Settings that decide what a coordinate word means.
bool changes_dimensions(Group g) {
    return g == Group::unit || g == Group::diameter;
}

template <class... F>
struct Cases : F... {
    using F::operator()...;
};
template <class... F>
Cases(F...) -> Cases<F...>;

/// T is one of the types of List.
template <class T, class... List>
concept OneOf = (std::is_same_v<T, List> || ...);

/// What rows that are `planned` make. They are named one by one, so that a function without a case does not compile.
template <class T>
concept Planned = OneOf<T, program::CornerFunction, program::CompensationSearch, program::Mirror, program::Scale,
                        program::RotaryPlane, program::WorkZone, program::AxisSwap, program::Coupling,
                        program::SpindlePhase, program::TangentialControl, program::TangentialPause,
                        program::InclinedAxis, program::HardStop, program::ThreadWithdrawal, program::ProbeMove,
                        operation::ContourRepeat, operation::StockRemoval, operation::Turning, operation::PeckDrilling,
                        operation::Threading, operation::Grooving, operation::LiveDrilling, operation::Keyway>;

/// What an M code makes, which is executed in iso_misc.cpp; and what rows that only set a modal group make: nothing.
template <class T>
concept Elsewhere = OneOf<T, std::monostate, program::ProgramStop, program::ProgramEnd, program::SpindleCommand,
                          program::ToolChange, program::OrientedStop, program::SpindleGear, program::LiveTool>;

}  // namespace

bool IsoRunner::Control::codes(const program::IsoBlock& block) {
    for (const FunctionCall& call : block.modal)
        if (!code(call)) return false;
    for (const FunctionCall& call : block.functions)
        if (!code(call)) return false;
    using program::FeedMode;
    using program::Motion;
    const program::Modal& m = state.modal;
    const bool turns = m.motion == Motion::thread || m.motion == Motion::variable_thread;
    if (m.corner == program::Corner::look_ahead && (turns || m.feed == FeedMode::per_revolution)) {
        const FunctionCall& at = block.modal.empty() ? block.functions.front() : block.modal.front();
        const Construct* other = turns ? motion_row : row_of(Group::feed, static_cast<std::uint8_t>(m.feed));
        const Construct* ahead = row_of(Group::corner, static_cast<std::uint8_t>(m.corner));
        session.report(diag::Id::incompatible_g, at.token, at.token + 1u, ahead ? ahead->code : "",
                       other ? other->code : "");
        return false;
    }
    if (form.units != nullptr && block.geometry.count != 0)
        session.report_once(diag::Id::setting_holds_here, form.units->token, form.units->token + 1u,
                            form.units->construct->code);
    if (form.machine != nullptr && block.geometry.count == 0) {
        const PerAxis<double> before = offsets.total();
        offsets.cancel();
        origin_changed(before);
        form.machine = nullptr;
    }
    return true;
}

bool IsoRunner::Control::code(const FunctionCall& call) {
    const Construct& row = *call.construct;
    if (row.support == control::Support::planned) {
        session.report(diag::Id::not_yet_supported, call.token, call.token + 1u, row.code, row.title);
        return false;
    }
    if (row.group == Group::motion) {  // in every plain block; states are kept by motion mode
        state.modal.motion = static_cast<program::Motion>(row.setting);
        motion_row = &row;
    } else if (row.group != Group::none) {
        set_group(call);
    }
    if (row.make == nullptr) return true;
    form_used = true;
    const auto function = filled(call);
    return function && act(call, *function) && !session.ends();
}

void IsoRunner::Control::set_group(const FunctionCall& call) {
    const Construct& row = *call.construct;
    program::Modal& m = state.modal;
    const program::Modal before = m;
    switch (row.group) {
        case Group::plane:
            m.plane_code = static_cast<program::PlaneCode>(row.setting);
            if (m.plane_code == program::PlaneCode::xy) set_plane(plane_g17);
            if (m.plane_code == program::PlaneCode::zx) set_plane(plane_g18);
            if (m.plane_code == program::PlaneCode::yz) set_plane(plane_g19);
            break;
        case Group::distance:
            m.distance = static_cast<program::Distance>(row.setting);
            break;
        case Group::unit:
            m.unit = static_cast<program::LengthUnit>(row.setting);
            break;
        case Group::diameter:
            m.x = static_cast<program::XWord>(row.setting);
            break;
        case Group::feed:
            m.feed = static_cast<program::FeedMode>(row.setting);
            break;
        case Group::speed:
            m.speed = static_cast<program::SpeedMode>(row.setting);
            if (m.speed == program::SpeedMode::constant_surface) form.surface = &call;
            break;
        case Group::spindle:
            m.spindle = static_cast<program::Spindle>(row.setting);
            break;
        case Group::corner:
            m.corner = static_cast<program::Corner>(row.setting);
            state.look_ahead = {};
            break;
        case Group::compensation:
            m.side = static_cast<program::Side>(row.setting);
            break;
        case Group::none:
        case Group::motion:
        case Group::origin:
        case Group::shift:
        case Group::count_:
            return;
    }
    form_used = form_used || form.surface != nullptr;
    if (m == before && m.corner != program::Corner::look_ahead) return;
    state_changed();
    if (changes_dimensions(row.group)) {
        units_changed();
        form.units = &call;
        form_used = true;
    }
    if (row.group == Group::speed && m.speed == program::SpeedMode::rpm && before.speed != m.speed)
        speeds[0] = surface_rpm();  // without S the present speed is kept (8055 T 5.3)
    technology_changed();
}

const Construct* IsoRunner::Control::row_of(Group group, std::uint8_t setting) const {
    for (const Construct* c : session.dialect.constructs)
        if (c->group == group && c->setting == setting) return c;
    return nullptr;
}

void IsoRunner::Control::set_plane(Plane plane) {
    if (plane == state.modal.plane) return;
    state.modal.plane = plane;
    polar = {};
    state_changed();
}

/// The neutral function of a code with its operands in it; that the block has them all was checked when it was bound.
std::optional<program::Function> IsoRunner::Control::filled(const FunctionCall& call) {
    const Construct& row = *call.construct;
    program::Function function = row.make();
    if (row.operands.empty() || row.takes == control::Takes::motion) return function;
    void* const target_function = row.target(function);
    for (const Word& w : session.block->shape->run(call.words)) {
        const Operand* operand = row.operand(w.address);
        if (operand == nullptr) {
            session.report(diag::Id::word_not_taken, w.token, w.end_token, w.address, row.code);
            return std::nullopt;
        }
        const Axis axis = axis_of(w.address).value_or(Axis::X);
        if (operand->address == control::any_axis && way[axis] == AxisWay::missing) {
            session.report(diag::Id::axis_not_of_machine, w.token, w.end_token, w.address);
            return std::nullopt;
        }
        const bool bare = w.value.kind == program::WordValue::Kind::none;
        const double value = bare && operand->role != Role::coordinate ? 0 : number(w);
        if (session.ends() || !allowed(row, *operand, w, value)) return std::nullopt;
        operand->slot.set(target_function, axis, converted(operand->role, axis, value));
    }
    return function;
}

bool IsoRunner::Control::act(const FunctionCall& call, const program::Function& function) {
    const auto table_row = [&](double row) -> const PerAxis<double>& {
        return session.machine.origins[static_cast<int>(row)];
    };
    const PerAxis<double> before = offsets.total();
    return std::visit(
        Cases{[&](const program::Dwell& f) { return form.dwell = f, true; },
              [&](const program::PlaneByAxes& f) {
                  return set_plane({f.axes.order[0], f.axes.order[1]}), true;
              },
              [&](const program::Preset& f) { return preset(call, f); },
              [&](const program::PolarOrigin& f) {
                  polar = {};
                  polar.origin = f.u ? Point{*f.u, *f.v} : plane_point();
                  return polar.placed = true;
              },
              [&](const program::AbsoluteOrigin& f) {
                  offsets.select(static_cast<std::uint16_t>(*f.row), table_row(*f.row));
                  return origin_changed(before), true;
              },
              [&](const program::IncrementalOrigin& f) {
                  offsets.add(static_cast<std::uint16_t>(*f.row), table_row(*f.row));
                  return origin_changed(before), true;
              },
              [&](const program::OriginShift& f) {
                  offsets.shift(f.axes);
                  return origin_changed(before), true;
              },
              [&](const program::Home& f) { return home(call, f), !session.ends(); },
              [&](const program::MachineCoordinates&) { return form.machine = &call, true; },
              [&](const program::AbsoluteCentre&) {
                  form.absolute_centre = true;
                  return form.arc_row = call.construct, true;
              },
              [&](const program::TangentArc&) {
                  form.arc = BlockForm::Arc::tangent;
                  return form.arc_row = call.construct, true;
              },
              [&](const program::ThreePointArc&) {
                  form.arc = BlockForm::Arc::three_points;
                  return form.arc_row = call.construct, true;
              },
              [&](const program::LookAhead& f) {
                  state.look_ahead = {f.acceleration.value_or(0), f.error.value_or(0), f.corner_angle.value_or(0)};
                  return state_changed(), true;
              },
              [&](const Planned auto&) {  // reached only by a row that lost its `planned` before there is a case
                  session.report(diag::Id::not_yet_supported, call.token, call.token + 1u, call.construct->code,
                                 call.construct->title);
                  return false;
              },
              [](const Elsewhere auto&) { return true; }},
        function);
}

bool IsoRunner::Control::preset(const FunctionCall& call, const program::Preset& f) {
    if (f.speed_limit) {
        state.speed_limit = *f.speed_limit;
        state_changed();
        return true;
    }
    const auto words = session.block->shape->run(call.words);
    PerAxis<double> tip = now.others;
    const PerAxis<double> before = offsets.total();
    for (const Word& w : words) {
        const Axis a = *axis_of(w.address);
        const double v = f.axes.value[a];
        if (session.machine.axes[a].rollover && !(v >= 0 && v <= 359.9999)) {
            session.report(diag::Id::rotary_preset_out_of_range, w.token, w.end_token, w.address, v);
            return false;
        }
        offsets.preset(a, tip[a] + before[a], v);
    }
    origin_changed(before);
    for (Axis a : all_axes)
        if (f.axes.given.has(a)) now.others[a] = programmed[a] = f.axes.value[a];
    return true;
}

void IsoRunner::Control::origin_changed(const PerAxis<double>& before) {
    const PerAxis<double>& zero = offsets.total();
    for (Axis a : all_axes) {
        now.others[a] += before[a] - zero[a];
        programmed[a] += before[a] - zero[a];
    }
    // A polar origin keeps its place on the machine (8055 T 3.6.2).
    const Plane p = state.modal.plane;
    if (polar.placed) polar.origin = polar.origin + Point{before[p.u] - zero[p.u], before[p.v] - zero[p.v]};
    now.at.frame = session.tables.frames.intern({zero, false});
}

void IsoRunner::Control::home(const FunctionCall& call, const program::Home& f) {
    if (f.axes.count == 0) return home_subroutine(call);
    using program::Motion;
    if (state.modal.motion == Motion::cw || state.modal.motion == Motion::ccw) {  // ends G02, G03 and G41, G42 (4.2)
        state.modal.motion = session.machine.power_on.motion;
        motion_row = row_of(Group::motion, static_cast<std::uint8_t>(state.modal.motion));
    }
    state.modal.side = program::Side::off;
    state_changed();
    operation::Event event;
    event.kind = operation::Event::Kind::home;
    event.axes = f.axes.given;
    // The home point is a place of the turret: the tip stands a tool length before it.
    for (Axis a : all_axes)
        if (f.axes.given.has(a))
            now.others[a] = programmed[a] = session.machine.axes[a].reference - offsets.total()[a] - tool_length(a);
    now.moved = {};
    emit(event);
    emit(operation::Barrier{operation::Barrier::Why::preparation});
    path.known = false;
}

/// G74 alone: the control's home subroutine (8055 T 4.2).
void IsoRunner::Control::home_subroutine(const FunctionCall& call) {
    const auto number = session.machine.home_subroutine;
    const auto exists = [&](std::uint32_t n) {
        return session.program->subroutine(n, false) != nullptr || session.library.subroutine(n).subroutine != nullptr;
    };
    if (number && exists(*number)) {
        outcome.subroutine = number;
        waiting.push_back({Waiting::For::home, 0, false});
    } else {
        const Text unnamed{"its number", "son numéro", "su número"};
        session.report(diag::Id::home_subroutine_missing, call.token, call.token + 1u,
                       number ? diag::Argument(*number) : diag::Argument(unnamed));
    }
}

void IsoRunner::Control::dwell(const program::Dwell& d) {
    using Why = operation::Barrier::Why;
    now.moved = {};
    if (!d.hundredths) {
        emit(operation::Barrier{Why::preparation});
    } else if (*d.hundredths == 0) {
        emit(operation::Barrier{Why::position});
    } else {
        emit(operation::Dwell{*d.hundredths / 100});
    }
}

}  // namespace fagorc::passes
