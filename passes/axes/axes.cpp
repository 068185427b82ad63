#include "passes/axes/axes.hpp"

#include <optional>

namespace fagorc::passes {
namespace {

using operation::Operation;

class Axes final : public Pass {
  public:
    using Pass::Pass;

    void push(const Operation& o) override {
        if (o.at.frame != frame_) select_frame(o.at.frame);
        if (still_) return emit(o);
        if (o.at.state != state_) select_plane(o.at.state);
        Operation moved = o;
        std::visit([this](auto& what) { place(what); }, moved.what);
        for (Axis a : all_axes) moved.others[a] += offset_[a];
        emit(moved);
    }

  private:
    // Kept, because most operations share frame and state with the one before.
    void select_frame(operation::FrameId id) {
        frame_ = id;
        state_.reset();
        const operation::Frame& frame = environment().tables.frames[id];
        offset_ = frame.machine ? PerAxis<double>{} : frame.offset;
        still_ = offset_ == PerAxis<double>{};
    }
    void select_plane(operation::StateId id) {
        state_ = id;
        const Plane plane = environment().tables.states[id].modal.plane;
        shift_ = {offset_[plane.u], offset_[plane.v]};
    }

    void place(operation::Line& l) const { l.end = l.end + shift_; }
    void place(operation::Thread& t) const { t.end = t.end + shift_; }
    void place(operation::Arc& a) const {
        a.end = a.end + shift_;
        a.centre = a.centre + shift_;
    }
    void place(operation::Dwell&) const {}
    void place(operation::Event&) const {}
    void place(operation::Barrier&) const {}

    std::optional<operation::FrameId> frame_;
    std::optional<operation::StateId> state_;
    PerAxis<double> offset_{};
    Point shift_;
    bool still_ = true;
};

}  // namespace

std::unique_ptr<Pass> make_axes(const Environment& environment, operation::Sink& next) {
    return std::make_unique<Axes>(environment, next);
}

}  // namespace fagorc::passes
