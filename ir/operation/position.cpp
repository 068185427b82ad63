#include "ir/operation/position.hpp"

namespace fagorc::operation {

bool Position::change_state(StateId id) {
    const State& s = tables_.states[id];
    const bool jumps = lengths_known_ && (s.length_x != length_x_ || s.length_z != length_z_);
    if (jumps) {
        at_[Axis::X] += length_x_ - s.length_x;
        at_[Axis::Z] += length_z_ - s.length_z;
    }
    state_ = id;
    plane_ = s.modal.plane;
    length_x_ = s.length_x;
    length_z_ = s.length_z;
    entered_ = lengths_known_ = true;
    return jumps;
}

}  // namespace fagorc::operation
