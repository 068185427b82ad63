// Arcs: by centre, by radius, polar, tangent, through three points; helices (8055 T 6.3 to 6.7).
#include <algorithm>
#include <cmath>
#include <string>

#include "passes/execute/iso_control.hpp"

namespace fagorc::passes {

using program::Distance;
using program::Motion;
using program::Word;
using Form = ArcForm;

namespace {

constexpr std::uint64_t blocks_looked_back = 48;  // as at compensated paths, 8055 T 8.2.5

}  // namespace

void IsoRunner::Control::arc(const MotionWords& words) {
    const Plane plane = state.modal.plane;
    for (Axis a : all_axes) {
        if (!(words.axes & positioning_axes).has(a)) continue;
        session.report_block(diag::Id::positioning_axis_not_allowed, letter(a), code_of_motion());
        return;
    }
    const Point start = plane_point();
    Form f{start, start, state.modal.motion == Motion::ccw, false, std::nullopt};
    bool found = false;
    const bool u = words.axes.has(plane.u), v = words.axes.has(plane.v);
    if (form.arc != BlockForm::Arc::by_motion) {
        found = other_arc(words, f);
    } else if (words.angle && (u || v || words.radius || words.angles > 1)) {
        session.report(diag::Id::coordinates_malformed, words.polar->token, words.polar->end_token,
                       words.polar->address);
    } else if (words.angle) {
        found = polar_arc(words, f);
    } else if (words.radius) {
        found = radius_arc(words, f);
    } else {
        found = programmed_arc(words, f);
    }
    if (!found || !exact(f)) return;
    emit_arc(f, words);
    if (session.machine.polar_origin_follows_arcs && form.arc == BlockForm::Arc::by_motion) {
        polar = {};
        polar.origin = f.centre;
        polar.placed = true;
    }
}

/// The end point by both coordinates of the plane, or by R and Q where the form takes them.
std::optional<Point> IsoRunner::Control::arc_end(const MotionWords& words) {
    const Plane plane = state.modal.plane;
    const bool u = words.axes.has(plane.u), v = words.axes.has(plane.v);
    if (u && v) return Point{target[plane.u], target[plane.v]};
    if (words.axes.empty()) {
        session.report_block(diag::Id::coordinates_incomplete, letter(plane.u));
        return std::nullopt;
    }
    AxisSet outside = words.axes;
    outside.remove(plane.u);
    outside.remove(plane.v);
    if (!outside.empty()) {
        session.report_block(diag::Id::point_outside_plane, std::string{letter(plane.u), letter(plane.v)});
    } else {
        session.report_block(diag::Id::coordinates_incomplete, letter(u ? plane.v : plane.u));
    }
    return std::nullopt;
}

/// Sorts I J K: those of the plane's axes are a point, one more is the pitch of a helix (8055 T 6.3, 6.7). Two plane
/// axes with one letter take it twice, in the order of the axes. Nothing: reported.
std::optional<CentreWords> IsoRunner::Control::centre_words(const MotionWords& words) {
    const Plane plane = state.modal.plane;
    const char lu = centre_letter(plane.u), lv = centre_letter(plane.v);
    const bool v_first = lu == lv && plane.v < plane.u;
    CentreWords out;
    for (std::size_t i = 0; i < words.centre_count; ++i) {
        const auto& [value, word] = words.centres[i];
        const char l = word->address;
        if (l == lv && !out.v && (l != lu || out.u || v_first)) {
            out.v = value;
        } else if (l == lu && !out.u) {
            out.u = value;
        } else if (!out.pitch) {
            out.pitch = pitch_word(words, words.centres[i]);
            if (!out.pitch) return std::nullopt;
        } else {
            session.report(diag::Id::coordinates_malformed, word->token, word->end_token, word->address);
            return std::nullopt;
        }
    }
    const bool absolute = form.absolute_centre || form.arc == BlockForm::Arc::three_points;
    if (absolute && out.u.has_value() != out.v.has_value())  // a letter left out is the coordinate 0 (8055 T 6.4, 6.6)
        session.report_once(diag::Id::centre_coordinate_missing, 0, 1, out.u ? lv : lu);
    return out;
}

/// The letter that is not of the plane: the pitch where a third axis moves, else a mistake.
std::optional<double> IsoRunner::Control::pitch_word(const MotionWords& words, const MotionWords::Centre& centre) {
    const Plane plane = state.modal.plane;
    const auto& [value, word] = centre;
    AxisSet outside = words.axes;
    outside.remove(plane.u);
    outside.remove(plane.v);
    if (outside.empty()) {
        const auto [first, second] = std::minmax({centre_letter(plane.u), centre_letter(plane.v)});
        session.report(diag::Id::centre_wrong, word->token, word->end_token, std::string{first, ' ', second});
    } else if (!(value > 0)) {
        session.report(diag::Id::pitch_wrong, word->token, word->end_token, value);
    } else {
        return value;
    }
    return std::nullopt;
}

/// `centre` comes as the start point.
bool IsoRunner::Control::centre_given(const MotionWords& words, Point& centre, std::optional<double>& pitch) {
    const auto given = centre_words(words);
    if (!given) return false;
    const Plane plane = state.modal.plane;
    const double u = given->u.value_or(0), v = given->v.value_or(0);
    if (form.absolute_centre) {
        centre = {u * scale[plane.u], v * scale[plane.v]};
    } else {
        centre = centre + Point{is_rotary(plane.u) ? u : u * unit, is_rotary(plane.v) ? v : v * unit};
    }
    if (given->pitch) pitch = *given->pitch * unit;
    return true;
}

/// End point and I J K, which are 0 where they are left out. Here and below `f` comes as the start point, with the
/// sense of the motion mode.
bool IsoRunner::Control::programmed_arc(const MotionWords& words, Form& f) {
    const Plane plane = state.modal.plane;
    const bool no_end = !words.axes.has(plane.u) && !words.axes.has(plane.v);
    if (no_end && words.centre_count != 0) {
        session.report_once(diag::Id::full_circle_without_end, 0, 1);
    } else {
        const auto end = arc_end(words);
        if (!end) return false;
        f.end = *end;
        if (words.centre_count == 0) {
            session.report_block(diag::Id::arc_centre_missing, code_of_motion());
            return false;
        }
    }
    if (!centre_given(words, f.centre, f.pitch)) return false;
    return true;
}

/// Q from the centre, which is the polar origin where I J K do not say it (8055 T 6.3).
bool IsoRunner::Control::polar_arc(const MotionWords& words, Form& f) {
    if (words.centre_count == 0) {
        f.centre = polar.origin;
    } else if (!centre_given(words, f.centre, f.pitch)) {
        return false;
    }
    const Point from_centre = plane_point() - f.centre;
    double angle = *words.angle;
    if (state.modal.distance == Distance::incremental) angle += degrees(std::atan2(from_centre.v, from_centre.u));
    f.end = f.centre + length(from_centre) * direction(angle);
    return true;
}

bool IsoRunner::Control::radius_arc(const MotionWords& words, Form& f) {
    const Point start = plane_point();
    const Word& word = *words.polar;
    if (form.absolute_centre || words.centre_count > 1) {
        session.report(diag::Id::centre_wrong, word.token, word.end_token, "R or I J K");
        return false;
    }
    const auto end = arc_end(words);
    if (!end) return false;
    f.end = *end;
    if (words.centre_count == 1) {  // the pitch of a helix
        const auto pitch = pitch_word(words, words.centres[0]);
        if (!pitch) return false;
        f.pitch = *pitch * unit;
    }
    const auto centre = centre_of_radius(start, *end, *words.radius, f.ccw, session.machine.arc_tolerance);
    if (!centre) {
        const double half = distance(start, *end) / 2;
        if (2 * half <= full_circle_chord) {
            session.report(diag::Id::full_circle_by_radius, word.token, word.end_token);
        } else {
            session.report(diag::Id::arc_radius_too_small, word.token, word.end_token, std::abs(*words.radius), half);
        }
        return false;
    }
    f.centre = *centre;
    return true;
}

/// G08 and G09: the modal motion plays no part (8055 T 6.5, 6.6).
bool IsoRunner::Control::other_arc(const MotionWords& words, Form& f) {
    const Plane plane = state.modal.plane;
    std::optional<Point> end;
    if (words.polar != nullptr && !words.axes.has(plane.u) && !words.axes.has(plane.v)) {
        end = polar_end(words);
    } else if (words.polar != nullptr) {
        session.report(diag::Id::coordinates_malformed, words.polar->token, words.polar->end_token,
                       words.polar->address);
    } else {
        end = arc_end(words);
    }
    if (!end) return false;
    const auto turn = form.arc == BlockForm::Arc::tangent ? tangent_turn(*end) : three_point_turn(words, *end, f.pitch);
    if (!turn) return false;
    f.end = *end;
    f.centre = turn->centre;
    f.ccw = turn->ccw;
    return true;
}

std::optional<Turn> IsoRunner::Control::tangent_turn(Point end) {
    if (!path.known || block_count - path.block - 1 > blocks_looked_back) {
        session.report_block(diag::Id::no_path_before, form.arc_row->code);
        return std::nullopt;
    }
    if (path.plane != state.modal.plane) {
        session.report_block(diag::Id::tangent_arc_plane);
        return std::nullopt;
    }
    const auto turn = tangent_arc(plane_point(), path.direction, end);
    if (turn && distance(turn->centre, plane_point()) <= largest_radius) return turn;
    session.report_block(diag::Id::tangent_arc_impossible);
    return std::nullopt;
}

/// I J K are a point of the arc, which counts from the start under G91 (8055 T 6.6).
std::optional<Turn> IsoRunner::Control::three_point_turn(const MotionWords& words, Point end,
                                                         std::optional<double>& pitch) {
    const auto given = centre_words(words);
    if (!given) return std::nullopt;
    if (!given->u && !given->v) {
        session.report_block(form.arc_row->misuse, form.arc_row->code, form.arc_row->syntax);
        return std::nullopt;
    }
    const Plane plane = state.modal.plane;
    const Point start = plane_point();
    Point middle{given->u.value_or(0) * scale[plane.u], given->v.value_or(0) * scale[plane.v]};
    if (state.modal.distance == Distance::incremental) middle = start + middle;
    if (given->pitch) pitch = *given->pitch * unit;
    const auto turn = arc_through(start, middle, end);
    if (turn && distance(turn->centre, start) <= largest_radius) return turn;
    session.report_block(diag::Id::arc_points_in_line);
    return std::nullopt;
}

/// Checks the radii at both ends; within the tolerance the centre gives way, so that the arc is exact (8055 T 6.3).
bool IsoRunner::Control::exact(Form& f) {
    const Point start = plane_point();
    const double radius = distance(f.centre, start);
    if (radius <= point_tolerance) {
        session.report_block(diag::Id::zero_radius_arc);
        return false;
    }
    const double off = std::abs(distance(f.centre, f.end) - radius);
    if (off > session.machine.arc_tolerance || radius > largest_radius) {
        session.report_block(diag::Id::arc_radii_disagree, off, session.machine.arc_tolerance);
        return false;
    }
    const Point chord = f.end - start;
    f.full = dot(chord, chord) <= full_circle_chord * full_circle_chord;
    if (f.full) {
        f.end = start;
    } else {
        f.centre = onto_bisector(start, f.end, f.centre);
    }
    return true;
}

void IsoRunner::Control::emit_arc(const Form& f, const MotionWords& words) {
    const Plane plane = state.modal.plane;
    now.moved = words.axes;
    now.moved.remove(plane.u);
    now.moved.remove(plane.v);
    const std::optional<int> turns = f.pitch ? whole_turns(f) : 0;
    if (!turns || (!cutting_checked && !cutting_allowed())) return;
    const Point start = plane_point();
    for (int i = 0; i < *turns; ++i) {
        for (Axis a : all_axes)
            if (now.moved.has(a)) now.others[a] += std::copysign(*f.pitch, target[a] - now.others[a]);
        emit(operation::Arc{start, f.centre, f.ccw, true});
    }
    if (!now.moved.empty())
        for (Axis a : all_axes)
            if (now.moved.has(a)) now.others[a] = programmed[a] = target[a];
    now.others[plane.u] = programmed[plane.u] = f.end.u;
    now.others[plane.v] = programmed[plane.v] = f.end.v;
    outcome.moved = true;
    auto& arc = make<operation::Arc>();
    arc.end = f.end;
    arc.centre = f.centre;
    arc.ccw = f.ccw;
    arc.full = f.full;
    send();
    path_ends(arc_direction(f.end, f.centre, f.ccw));
}

/// The whole turns of a helix before its last part; nothing: height, pitch and arc do not fit (8055 T 6.7).
std::optional<int> IsoRunner::Control::whole_turns(const Form& f) {
    Axis along{};
    int axes = 0;
    for (Axis a : all_axes)
        if (now.moved.has(a)) along = a, ++axes;
    const Point start = plane_point();
    const double whole = 2 * std::numbers::pi;
    const double height = axes == 1 ? target[along] - now.others[along] : 0;
    const double angle = swept_angle(start, f.end, f.centre, f.ccw, f.full);
    const double turns = (whole * std::abs(height) / *f.pitch - angle) / whole;
    const double count = std::round(turns);
    const double miss = std::abs(turns - count) * whole * distance(f.centre, start);
    if (axes != 1 || count < 0 || miss > session.machine.arc_tolerance) {
        session.report_block(diag::Id::helix_wrong);
        return std::nullopt;
    }
    return static_cast<int>(count);
}

}  // namespace fagorc::passes
