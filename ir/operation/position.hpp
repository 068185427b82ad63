// Where the tool tip stands: the start of a move, which an operation does not say.
#pragma once

#include "ir/machine/machine.hpp"
#include "ir/operation/operation.hpp"

namespace fagorc::operation {

/// Follows the operations of one stream: the tip's machine coordinates, mm (X as a radius) or degrees.
class Position {
  public:
    Position(const Tables& tables, const machine::Machine& machine)
        : tables_(tables), at_(machine.start), lengths_known_(machine.start_offset == 0) {}

    /// Takes the operation's state: the plane, and the tip, which stands elsewhere once the tool lengths have changed
    /// (8055 T 8.1). True when it does. To be called for every operation, before `move` and `home`.
    bool enter(const Operation& o) { return (!entered_ || o.at.state != state_) && change_state(o.at.state); }
    /// The end of a move: the plane's point, and the other axes that it moves.
    void move(const Operation& o, Point end) {
        at_[plane_.u] = end.u;
        at_[plane_.v] = end.v;
        if (!o.moved.empty()) take(o, o.moved);
    }
    /// The end of a home search of some axes.
    void home(const Operation& o, AxisSet axes) { take(o, axes); }

    const PerAxis<double>& axes() const { return at_; }
    Point point() const { return {at_[plane_.u], at_[plane_.v]}; }
    Plane plane() const { return plane_; }

  private:
    bool change_state(StateId id);
    void take(const Operation& o, AxisSet axes) {
        for (Axis a : all_axes)
            if (axes.has(a)) at_[a] = o.others[a];
    }

    const Tables& tables_;
    PerAxis<double> at_;
    Plane plane_;
    StateId state_{};
    double length_x_ = 0, length_z_ = 0;
    bool entered_ = false;
    bool lengths_known_;  ///< false: the program starts with an offset whose lengths its first operation tells
};

}  // namespace fagorc::operation
