// The spindle as ISO blocks say it.
#pragma once

#include <optional>
#include <string>

#include "ir/operation/context.hpp"

namespace fagorc::backends::iso {

/// Remembers what has been said about speed and sense, and says what is new.
class Spindle {
  public:
    /// The words that bring the spindle to a state, e.g. "G97 S1000 M3"; empty when nothing is new.
    std::string words(const operation::State& state, double speed);

  private:
    program::SpeedMode mode_ = program::SpeedMode::rpm;  // as the first block sets it
    double speed_ = 0, limit_ = 0;
    operation::SpindleTurn turn_ = operation::SpindleTurn::stopped;
};

}  // namespace fagorc::backends::iso
