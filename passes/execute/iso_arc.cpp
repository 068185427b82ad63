// Arcs: by centre, by radius, polar, tangent, through three points; helices (8055 T 6.3 to 6.7).
#include <cmath>

#include "ir/base/arc.hpp"
#include "passes/execute/iso_control.hpp"

namespace fagorc::passes {

using program::Distance;
using program::Motion;
using program::Word;
using Form = ArcForm;

namespace {

constexpr std::uint64_t blocks_looked_back = 48;  // as at compensated paths, 8055 T 8.2.5

bool take_turn(Point end, const Turn& turn, Form& f) {
    f.end = end;
    f.centre = turn.centre;
    f.ccw = turn.ccw;
    return true;
}

}  // namespace

void IsoRunner::Control::arc(const MotionWords& words) {
    const Plane plane = state.modal.plane;
    for (Axis a : all_axes) {
        if (!(words.axes & positioning_axes).has(a)) continue;
        session.report_block(diag::Id::positioning_axis_not_allowed, letter(a), code_of_motion());
        return;
    }
    if (!cutting_checked && !cutting_allowed()) return;
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

/// Sorts I J K: those of the plane's axes are the centre, one more is the pitch of a helix (8055 T 6.3, 6.7). Two plane
/// axes with one letter take it twice, in the order of the axes. `centre` comes as the start point.
bool IsoRunner::Control::centre_given(const MotionWords& words, Point& centre, std::optional<double>& pitch) {
    const Plane plane = state.modal.plane;
    const char lu = centre_letter(plane.u), lv = centre_letter(plane.v);
    const bool v_first = lu == lv && plane.v < plane.u;
    bool has_u = false, has_v = false;
    const bool absolute = form.absolute_centre;
    const auto put = [&](double& coordinate, bool& has, Axis axis, double value) {
        coordinate = absolute ? value * scale[axis] : coordinate + (is_rotary(axis) ? value : value * unit);
        has = true;
    };
    for (std::size_t i = 0; i < words.centre_count; ++i) {
        const auto [value, word] = words.centres[i];
        const char l = word->address;
        if (l == lv && !has_v && (l != lu || has_u || v_first)) {
            put(centre.v, has_v, plane.v, value);
        } else if (l == lu && !has_u) {
            put(centre.u, has_u, plane.u, value);
        } else if (!pitch) {
            pitch = value * unit;
            if (!(*pitch > 0)) {
                session.report(diag::Id::pitch_wrong, word->token, word->end_token, value);
                return false;
            }
        } else {
            session.report(diag::Id::coordinates_malformed, word->token, word->end_token, word->address);
            return false;
        }
    }
    if (absolute && !(has_u && has_v)) {  // a letter left out is the coordinate 0 (8055 T 6.4)
        session.report_once(diag::Id::centre_coordinate_missing, 0, 1, has_u ? lv : lu);
        if (!has_u) centre.u = 0;
        if (!has_v) centre.v = 0;
    }
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
        f.pitch = words.centres[0].value * unit;
        if (!(*f.pitch > 0)) {
            const Word& p = *words.centres[0].word;
            session.report(diag::Id::pitch_wrong, p.token, p.end_token, words.centres[0].value);
            return false;
        }
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
    const Point start = plane_point();
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
    const auto& code = form.arc_row->code;
    std::optional<Turn> turn;
    if (form.arc == BlockForm::Arc::tangent) {
        if (!path.known || block_count - path.block - 1 > blocks_looked_back) {
            session.report_block(diag::Id::no_path_before, code);
            return false;
        }
        if (path.plane != plane) {
            session.report_block(diag::Id::tangent_arc_plane);
            return false;
        }
        turn = tangent_arc(start, path.direction, *end);
        if (!turn || distance(turn->centre, start) > largest_radius) {
            session.report_block(diag::Id::tangent_arc_impossible);
            return false;
        }
        return take_turn(*end, *turn, f);
    }
    Point middle{};
    for (std::size_t i = 0; i < words.centre_count; ++i) {
        const auto [value, word] = words.centres[i];
        if (word->address == centre_letter(plane.u)) middle.u = value * scale[plane.u];
        if (word->address == centre_letter(plane.v)) middle.v = value * scale[plane.v];
    }
    if (words.centre_count < 2) session.report_once(diag::Id::centre_coordinate_missing, 0, 1, code);
    if (state.modal.distance == Distance::incremental) middle = start + middle;
    turn = arc_through(start, middle, *end);
    if (!turn || distance(turn->centre, start) > largest_radius) {
        session.report_block(diag::Id::arc_points_in_line);
        return false;
    }
    return take_turn(*end, *turn, f);
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
    if (f.pitch && !whole_turns(f)) return;
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

/// The whole turns of a helix before its last part; false: height, pitch and arc do not fit (8055 T 6.7).
bool IsoRunner::Control::whole_turns(const Form& f) {
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
        return false;
    }
    for (int i = 0; i < static_cast<int>(count); ++i) {
        now.others[along] += std::copysign(*f.pitch, height);
        emit(operation::Arc{start, f.centre, f.ccw, true});
    }
    return true;
}

}  // namespace fagorc::passes
