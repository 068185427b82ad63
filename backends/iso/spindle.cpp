#include "backends/iso/spindle.hpp"

#include "backends/text.hpp"

namespace fagorc::backends::iso {
namespace {

constexpr int decimals = 3;

/// An oriented spindle stands.
operation::SpindleTurn turning(operation::SpindleTurn turn) {
    return turn == operation::SpindleTurn::oriented ? operation::SpindleTurn::stopped : turn;
}

const char* function(operation::SpindleTurn turn) {
    switch (turn) {
        case operation::SpindleTurn::clockwise:
            return "M3";
        case operation::SpindleTurn::counter_clockwise:
            return "M4";
        case operation::SpindleTurn::stopped:
        case operation::SpindleTurn::oriented:
            break;
    }
    return "M5";
}

}  // namespace

std::string Spindle::words(const operation::State& state, double speed) {
    std::string out;
    const bool surface = state.modal.speed == program::SpeedMode::constant_surface;
    const bool new_mode = state.modal.speed != mode_ || (surface && state.speed_limit != limit_);
    if (new_mode) {
        out = surface ? "G96" : "G97";
        if (surface && state.speed_limit > 0) append_trimmed(out += " D", state.speed_limit, decimals);
    }
    if (new_mode || speed != speed_) append_trimmed(out += out.empty() ? "S" : " S", speed, decimals);
    if (const auto turn = turning(state.turn); turn != turn_) {
        if (!out.empty()) out += ' ';
        out += function(turn);
        turn_ = turn;
    }
    mode_ = state.modal.speed;
    speed_ = speed;
    limit_ = state.speed_limit;
    return out;
}

}  // namespace fagorc::backends::iso
