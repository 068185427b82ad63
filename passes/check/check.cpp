#include "passes/check/check.hpp"

#include <algorithm>

#include "ir/base/geometry.hpp"
#include "ir/operation/position.hpp"

namespace fagorc::passes {
namespace {

using operation::Operation;

class Check final : public Pass {
  public:
    Check(const Environment& environment, operation::Sink& next)
        : Pass(environment, next), tip_(environment.tables, environment.machine) {
        for (Axis a : all_axes)
            if (environment.machine.axes[a].min || environment.machine.axes[a].max) limited_.add(a);
    }

    void push(const Operation& o) override {
        if (!limited_.empty()) follow(o);
        emit(o);
    }

  private:
    void follow(const Operation& o) {
        tip_.enter(o);
        if (operation::is_motion(o.what)) return travel(o);
        const auto* event = std::get_if<operation::Event>(&o.what);
        if (event && event->kind == operation::Event::Kind::home) tip_.home(o, event->axes);
    }

    void travel(const Operation& o) {
        const Plane plane = tip_.plane();
        const Point end = std::visit([](const auto& what) { return end_of(what); }, o.what);
        Point low = end, high = end;
        if (const auto* arc = std::get_if<operation::Arc>(&o.what)) extremes(*arc, low, high);
        inside(o.at, plane.u, low.u, high.u);
        inside(o.at, plane.v, low.v, high.v);
        for (Axis a : all_axes)
            if (o.moved.has(a) && !plane.has(a)) inside(o.at, a, o.others[a], o.others[a]);
        tip_.move(o, end);
    }

    /// Widens [low, high] by the quarter points of the circle that the arc passes.
    void extremes(const operation::Arc& arc, Point& low, Point& high) const {
        const Point start = tip_.point();
        const double r = distance(arc.centre, arc.end);
        const double sweep = swept_angle(start, arc.end, arc.centre, arc.ccw, arc.full);
        for (const Point quarter : {Point{r, 0}, Point{0, r}, Point{-r, 0}, Point{0, -r}}) {
            const Point p = arc.centre + quarter;
            if (!arc.full && swept_angle(start, p, arc.centre, arc.ccw, false) > sweep) continue;
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
    operation::Position tip_;
};

}  // namespace

std::unique_ptr<Pass> make_check(const Environment& environment, operation::Sink& next) {
    return std::make_unique<Check>(environment, next);
}

}  // namespace fagorc::passes
