// Straight moves and threads: cartesian, polar, angle and one coordinate, rotary axes (8055 T 3.4
// to 3.7, 6.1, 6.2, 6.12).
#include <algorithm>
#include <cmath>

#include "passes/execute/iso_control.hpp"

namespace fagorc::passes {

using control::Construct;
using control::Operand;
using program::Distance;
using program::Motion;
using program::Word;

namespace {

constexpr std::uint32_t bit(char address) {
    return 1u << (address - 'A');
}
constexpr std::uint32_t axis_letters = [] {
    std::uint32_t bits = 0;
    for (Axis a : all_axes) bits |= bit(letter(a));
    return bits;
}();

constexpr unsigned linear_axes = (1u << index(Axis::A)) - 1;

constexpr double full_turn = 360, largest_angle = 359.9999;
constexpr double half_step = 0.00005;  // of the last decimal of an angle

}  // namespace

void IsoRunner::Control::move(const program::IsoBlock& block) {
    const auto words = session.block->shape->run(block.geometry);
    const Motion motion = state.modal.motion;
    const bool straight = motion == Motion::rapid || motion == Motion::line;
    if (straight && form.arc_row == nullptr && form.machine == nullptr && (block.letters & ~axis_letters) == 0)
        [[likely]] {
        plain_line(words);
        return;
    }
    MotionWords w;
    if (!gather(words, w) || !positioning_rules(w)) return;
    if (form.machine != nullptr) {
        if (w.polar != nullptr) {
            session.report(diag::Id::polar_not_allowed, w.polar->token, w.polar->end_token,
                           form.machine->construct->code);
            return;
        }
        if (state.modal.distance == Distance::incremental)
            session.report_once(diag::Id::machine_coordinates_absolute, form.machine->token, form.machine->token + 1u,
                                form.machine->construct->code);
    }
    if (form.arc_row != nullptr || motion == Motion::cw || motion == Motion::ccw) {
        arc(w);
    } else if (straight) {
        line(w);
    } else {
        thread(w);
    }
}

void IsoRunner::Control::plain_line(std::span<const Word> words) {
    const Point start = plane_point();
    const bool absolute = state.modal.distance == Distance::absolute;
    AxisSet moved;
    for (const Word& word : words) {
        const Axis a = *axis_of(word.address);
        const double v = coordinate_word(word);
        if (way[a] == AxisWay::straight) [[likely]] {
            programmed[a] = absolute ? v * scale[a] : programmed[a] + v * scale[a];
        } else {
            programmed[a] = rotary_destination(a, v, word);
        }
        now.others[a] = programmed[a];
        moved.add(a);
    }
    if (session.ends()) return;
    const bool rapid = state.modal.motion == Motion::rapid;
    if ((moved.bits & ~linear_axes) != 0) {
        MotionWords w;
        w.axes = moved;
        if (!positioning_rules(w)) return;
    }
    if (!rapid && !cutting_checked && !cutting_allowed()) return;
    outcome.moved = true;
    emit_line(start, moved);
}

/// To the tip's new place from `start`; `moved`: the axes with a word.
void IsoRunner::Control::emit_line(Point start, AxisSet moved) {
    const Plane plane = state.modal.plane;
    moved.remove(plane.u);
    moved.remove(plane.v);
    now.moved = moved;
    const Point end = plane_point();
    const double feed = now.at.feed;
    // Rotary axes alone turn at degrees a minute, also under G70 (8055 T 5.2).
    if (end == start && unit != 1 && !moved.empty() && (moved.bits & linear_axes) == 0) now.at.feed = feed / unit;
    auto& line = make<operation::Line>();
    line.end = end;
    line.rapid = state.modal.motion == Motion::rapid;
    send();
    now.at.feed = feed;
    if (end != start) path_ends(end - start);
}

/// The operands of the motion mode in force by letter; null where no code has set it.
const IsoRunner::Control::Spelling* IsoRunner::Control::motion_spelling() {
    if (motion_row == nullptr) return nullptr;
    Spelling& known = spellings[static_cast<std::size_t>(state.modal.motion)];
    if (known.row != motion_row) {
        known.row = motion_row;
        for (char c = 'A'; c <= 'Z'; ++c) known.operands[static_cast<std::size_t>(c - 'A')] = motion_row->operand(c);
    }
    return &known;
}

bool IsoRunner::Control::gather(std::span<const Word> words, MotionWords& out) {
    const bool by_motion = form.arc_row == nullptr || form.arc == BlockForm::Arc::by_motion;
    const Spelling* const spelling = by_motion ? motion_spelling() : nullptr;
    for (const Word& word : words) {
        const Construct* row = form.arc_row;
        const Operand* operand = row != nullptr ? row->operand(word.address) : nullptr;
        if (operand == nullptr && spelling != nullptr) {
            row = spelling->row;
            operand = spelling->operands[static_cast<std::size_t>(word.address - 'A')];
        }
        if (operand == nullptr) {
            session.report(diag::Id::coordinates_malformed, word.token, word.end_token, word.address);
            return false;
        }
        if (const auto axis = axis_of(word.address)) {
            target[*axis] = destination(*axis, coordinate_word(word), word);
            out.axes.add(*axis);
            continue;
        }
        const double raw = number(word);
        if (session.ends() || !allowed(*row, *operand, word, raw)) return false;
        const auto value = [&] { return converted(operand->role, Axis::Z, raw); };
        if ((word.address == 'R' || word.address == 'Q') && out.polar == nullptr) out.polar = &word;
        switch (word.address) {
            case 'R':
                out.radius = value();
                break;
            case 'L':
                out.lead = value();
                break;
            case 'Q':
                out.angle = value();
                ++out.angles;
                break;
            default:  // a centre: its axis, and so its unit, depends on the plane
                if (out.centre_count < out.centres.size()) out.centres[out.centre_count++] = {raw, &word};
        }
    }
    return !session.ends();
}

double IsoRunner::Control::destination(Axis a, double v, const Word& word) {
    if (form.machine != nullptr && way[a] != AxisWay::missing) {  // in the unit of the machine, without a tool (4.3)
        const bool inch = session.machine.inches_parameter == program::LengthUnit::inch;
        const double mm = is_rotary(a) ? v : v * (inch ? 25.4 : 1);
        const bool diameter = a == Axis::X && state.modal.x == program::XWord::diameter;
        return (diameter ? mm / 2 : mm) - tool_length(a) - offsets.total()[a];
    }
    if (way[a] != AxisWay::straight) return rotary_destination(a, v, word);
    return state.modal.distance == Distance::absolute ? v * scale[a] : programmed[a] + v * scale[a];
}

double IsoRunner::Control::rotary_destination(Axis a, double v, const Word& word) {
    if (way[a] == AxisWay::missing) {
        session.report(diag::Id::axis_not_of_machine, word.token, word.end_token, word.address);
        return 0;
    }
    const machine::AxisData& axis = session.machine.axes[a];
    if (axis.type == machine::AxisType::hirth && v != std::trunc(v) && !is_unknown(v)) {
        session.report(diag::Id::hirth_with_decimals, word.token, word.end_token, word.address, v);
        return 0;
    }
    if (state.modal.distance == Distance::incremental) return programmed[a] + v * scale[a];
    const double here = programmed[a];
    switch (way[a]) {
        case AxisWay::turning: {
            if (std::abs(v) > largest_angle) {
                session.report(diag::Id::rotary_axis_out_of_range, word.token, word.end_token, word.address, v);
                return here;
            }
            double turn = std::fmod(std::abs(v) - here, full_turn);  // the sign is the sense, not a value
            if (std::signbit(v)) turn = -turn;
            if (turn < 0) turn += full_turn;
            if (turn > full_turn - half_step) turn -= full_turn;  // it stands there already
            return std::signbit(v) ? here - turn : here + turn;
        }
        case AxisWay::shortest:
            if (v < 0 || v > largest_angle) {
                session.report(diag::Id::positioning_axis_out_of_range, word.token, word.end_token, word.address, v);
                return here;
            }
            return here + std::remainder(v - here, full_turn);
        case AxisWay::straight:
        case AxisWay::indexed:
        case AxisWay::missing:
            break;
    }
    return v * scale[a];
}

/// One Hirth axis in a block, one positioning axis in a G01 block (8055 T 3.7, 6.2).
bool IsoRunner::Control::positioning_rules(const MotionWords& words) {
    if ((words.axes & hirth_axes).several()) {
        session.report_block(diag::Id::two_hirth_axes);
    } else if ((words.axes & positioning_axes).several() && state.modal.motion == Motion::line) {
        session.report_block(diag::Id::two_positioning_axes);
    } else {
        return true;
    }
    return false;
}

void IsoRunner::Control::line(const MotionWords& words) {
    const Plane plane = state.modal.plane;
    const bool u = words.axes.has(plane.u), v = words.axes.has(plane.v);
    std::optional<Point> end;
    if (words.polar == nullptr) {
        end = Point{u ? target[plane.u] : now.others[plane.u], v ? target[plane.v] : now.others[plane.v]};
    } else if (words.angles > 1) {
        session.report(diag::Id::two_angles, words.polar->token, words.polar->end_token);
    } else if ((u != v) && !words.radius) {
        end = angle_end(words);
    } else if (u || v) {
        session.report(diag::Id::coordinates_malformed, words.polar->token, words.polar->end_token,
                       words.polar->address);
    } else {
        end = polar_end(words);
    }
    const bool rapid = state.modal.motion == Motion::rapid;
    if (!end || session.ends() || (!rapid && !cutting_checked && !cutting_allowed())) return;

    const Point start = plane_point();
    AxisSet moved = words.axes;
    for (Axis a : all_axes)
        if (moved.has(a)) now.others[a] = programmed[a] = target[a];
    if (words.polar != nullptr) {
        programmed[plane.u] = end->u;
        programmed[plane.v] = end->v;
    }
    now.others[plane.u] = end->u;
    now.others[plane.v] = end->v;
    outcome.moved = true;
    emit_line(start, moved);
}

/// R and Q about the polar origin; one that is missing stays as it is (8055 T 3.6.2).
std::optional<Point> IsoRunner::Control::polar_end(const MotionWords& words) {
    const Point here{programmed[state.modal.plane.u], programmed[state.modal.plane.v]};
    double radius = polar.radius, angle = polar.angle;
    if (here != polar.at || radius == 0) {
        const Point from_origin = here - polar.origin;
        radius = length(from_origin);
        if (radius > point_tolerance) angle = degrees(std::atan2(from_origin.v, from_origin.u));
    }
    const Word& word = *words.polar;
    if (state.modal.distance == Distance::absolute) {
        radius = words.radius.value_or(radius);
        angle = words.angle.value_or(angle);
        if (radius < 0) {
            session.report(diag::Id::negative_absolute_polar_radius, word.token, word.end_token, radius);
            return std::nullopt;
        }
    } else {
        radius += words.radius.value_or(0);
        angle += words.angle.value_or(0);
        if (radius < -point_tolerance) {
            session.report(diag::Id::negative_polar_radius, word.token, word.end_token, radius);
            return std::nullopt;
        }
    }
    const Point end = polar.origin + radius * direction(angle);
    polar.at = end;
    polar.radius = radius;
    polar.angle = angle;
    return end;
}

/// Q is the absolute angle of the path with the abscissa, one coordinate says where it ends (8055 T 3.6.3).
std::optional<Point> IsoRunner::Control::angle_end(const MotionWords& words) {
    const Plane plane = state.modal.plane;
    const Point start = plane_point(), d = direction(*words.angle);
    const bool by_u = words.axes.has(plane.u);
    const double along = by_u ? d.u : d.v;
    const double way_along = by_u ? target[plane.u] - start.u : target[plane.v] - start.v;
    const Word& word = *words.polar;
    if (std::abs(along) < 1e-9) {
        session.report(diag::Id::angle_cannot_reach, word.token, word.end_token, *words.angle,
                       letter(by_u ? plane.u : plane.v));
        return std::nullopt;
    }
    const double t = way_along / along;
    if (t < -point_tolerance) session.report_once(diag::Id::point_behind, word.token, word.end_token, *words.angle);
    return by_u ? Point{target[plane.u], start.v + t * d.v} : Point{start.u + t * d.u, target[plane.v]};
}

void IsoRunner::Control::thread(const MotionWords& words) {
    const Plane plane = state.modal.plane;
    if (!words.lead || *words.lead <= 0) {
        session.report_block(motion_row->misuse, motion_row->code, motion_row->syntax);
        return;
    }
    if (words.angle && session.machine.m19_type == 0) {
        session.report(diag::Id::thread_angle_not_possible, words.polar->token, words.polar->end_token);
        return;
    }
    if (words.axes.empty()) {
        session.report_block(diag::Id::axes_expected, motion_row->code);
        return;
    }
    if (!cutting_allowed()) return;
    const Point start = plane_point();
    double squares = 0, major = 0;
    for (Axis a : all_axes) {
        if (!words.axes.has(a)) continue;
        const double way_of_axis = target[a] - now.others[a];
        squares += way_of_axis * way_of_axis;
        major = std::max(major, std::abs(way_of_axis));
        now.others[a] = programmed[a] = target[a];
    }
    // The manual does not say along what the lead of a taper is measured (8055 T 6.12).
    const bool along_axis = session.machine.policy.thread_lead == machine::Policies::ThreadLead::major_axis;
    const double lead = along_axis && major > 0 ? *words.lead * std::sqrt(squares) / major : *words.lead;
    now.moved = words.axes;
    now.moved.remove(plane.u);
    now.moved.remove(plane.v);
    outcome.moved = true;
    const Point end = plane_point();
    emit(operation::Thread{end, lead, words.angle.value_or(0)});
    if (end != start) path_ends(end - start);
}

}  // namespace fagorc::passes
