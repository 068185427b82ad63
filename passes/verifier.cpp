#include "passes/verifier.hpp"

#include <cmath>
#include <optional>
#include <string>

#include "ir/operation/position.hpp"

namespace fagorc::passes {
namespace {

using namespace operation;

/// Largest difference of an arc's radii that rounding explains, mm: arcs are exact from the executor on (8055 T 6.3).
constexpr double radius_tolerance = 1e-6;

bool finite(Point p) {
    return std::isfinite(p.u) && std::isfinite(p.v);
}

class Verifier final : public Pass {
  public:
    Verifier(const Environment& environment, Sink& next, std::string_view after)
        : Pass(environment, next), after_(after), tip_(environment.tables, environment.machine) {}

    void push(const Operation& o) override {
        const Tables& tables = environment().tables;
        const bool state = static_cast<std::uint32_t>(o.at.state) < tables.states.size();
        hold(state && static_cast<std::uint32_t>(o.at.frame) < tables.frames.size() &&
                 static_cast<std::uint32_t>(o.at.chain) < tables.chains.size(),
             o, "a handle names nothing");
        if (state) tip_.enter(o);
        std::visit([&](const auto& what) { verify(o, what); }, o.what);
        emit(o);
    }

  private:
    void hold(bool condition, const Operation& o, std::string_view what) {
        if (!condition)
            environment().diagnostics.report(diag::Id::invariant_broken, environment().places.of(o.at), after_, what);
    }

    void verify(const Operation& o, const Line& l) { arrive(o, l.end); }
    void verify(const Operation& o, const Thread& t) {
        hold(t.lead != 0, o, "a thread has no lead");
        arrive(o, t.end);
    }
    void verify(const Operation& o, const Arc& a) {
        hold(finite(a.centre), o, "a centre is not a number");
        const double end_radius = distance(a.centre, a.end);
        hold(end_radius > 0, o, "an arc has no radius");
        if (o.at.frame == frame_) {
            const Point start = tip_.point();
            hold(std::abs(distance(a.centre, start) - end_radius) <= radius_tolerance * std::max(1.0, end_radius), o,
                 "the radii of an arc disagree");
            hold(!a.full || distance(start, a.end) <= full_circle_chord, o, "a full circle does not close");
        }
        arrive(o, a.end);
    }
    void verify(const Operation& o, const Dwell& d) { hold(d.seconds >= 0, o, "a dwell is negative"); }
    void verify(const Operation& o, const Event& e) {
        if (e.kind == Event::Kind::home) tip_.home(o, e.axes);
    }
    void verify(const Operation&, const Barrier&) {}

    void arrive(const Operation& o, Point end) {
        hold(finite(end), o, "a coordinate is not a number");
        for (double other : o.others) hold(std::isfinite(other), o, "a coordinate is not a number");
        tip_.move(o, end);
        frame_ = o.at.frame;
    }

    std::string after_;
    Position tip_;
    /// Of the last move: before the offsets are added its end is the start of the next one in the same frame only.
    std::optional<FrameId> frame_;
};

}  // namespace

std::unique_ptr<Pass> make_verifier(const Environment& environment, Sink& next, std::string_view after) {
    return std::make_unique<Verifier>(environment, next, after);
}

}  // namespace fagorc::passes
