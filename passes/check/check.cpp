#include "passes/check/check.hpp"

#include <algorithm>
#include <optional>

#include "ir/base/geometry.hpp"

namespace fagorc::passes {
namespace {

using operation::Operation;

class Check final : public Pass {
  public:
    Check(const Environment& environment, operation::Sink& next) : Pass(environment, next) {
        for (Axis a : all_axes)
            if (environment.machine.axes[a].min || environment.machine.axes[a].max) limited_.add(a);
    }

    void push(const Operation& o) override {
        if (!limited_.empty() && operation::is_motion(o.what)) travel(o);
        emit(o);
    }

  private:
    void travel(const Operation& o) {
        const Plane plane = environment().tables.states[o.at.state].modal.plane;
        const Point end = std::visit([](const auto& what) { return end_of(what); }, o.what);
        Point low = end, high = end;
        if (const auto* arc = std::get_if<operation::Arc>(&o.what)) extremes(*arc, plane, low, high);
        inside(o.at, plane.u, low.u, high.u);
        inside(o.at, plane.v, low.v, high.v);
        for (Axis a : all_axes)
            if (o.moved.has(a) && !plane.has(a)) inside(o.at, a, o.others[a], o.others[a]);
        at_ = end;
        plane_ = plane;
    }

    /// Widens [low, high] by the quarter points of the circle that the arc passes; its start is the end of the move
    /// before, which is known while the plane stays the same.
    void extremes(const operation::Arc& arc, Plane plane, Point& low, Point& high) const {
        if (plane != plane_) return;
        const double r = distance(arc.centre, arc.end);
        const double sweep = swept_angle(at_, arc.end, arc.centre, arc.ccw, arc.full);
        for (const Point quarter : {Point{r, 0}, Point{0, r}, Point{-r, 0}, Point{0, -r}}) {
            const Point p = arc.centre + quarter;
            if (!arc.full && swept_angle(at_, p, arc.centre, arc.ccw, false) > sweep) continue;
            low = {std::min(low.u, p.u), std::min(low.v, p.v)};
            high = {std::max(high.u, p.u), std::max(high.v, p.v)};
        }
    }

    void inside(const operation::Context& at, Axis axis, double low, double high) {
        const machine::AxisData& data = environment().machine.axes[axis];
        if (data.max && high > *data.max + point_tolerance) report(at, axis, high, *data.max);
        if (data.min && low < *data.min - point_tolerance) report(at, axis, low, *data.min);
    }

    void report(const operation::Context& at, Axis axis, double value, double limit) {
        environment().diagnostics.report(diag::Id::travel_limit_exceeded, environment().places.of(at), letter(axis),
                                         value, limit);
    }

    static Point end_of(const operation::Line& l) { return l.end; }
    static Point end_of(const operation::Arc& a) { return a.end; }
    static Point end_of(const operation::Thread& t) { return t.end; }
    template <class Still>
    static Point end_of(const Still&) {
        return {};
    }

    AxisSet limited_;
    Point at_;
    std::optional<Plane> plane_;
};

}  // namespace

std::unique_ptr<Pass> make_check(const Environment& environment, operation::Sink& next) {
    return std::make_unique<Check>(environment, next);
}

}  // namespace fagorc::passes
