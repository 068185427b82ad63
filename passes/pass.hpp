// What a pass is: it takes operations, holds no more than its geometry needs, and pushes on.
#pragma once

#include "passes/pipeline.hpp"

namespace fagorc::passes {

class Pass : public operation::Sink {
  public:
    Pass(const Environment& environment, operation::Sink& next) : environment_(environment), next_(next) {}
    void finish() override { next_.finish(); }

  protected:
    void emit(const operation::Operation& o) { next_.push(o); }
    const Environment& environment() const { return environment_; }

  private:
    Environment environment_;
    operation::Sink& next_;
};

}  // namespace fagorc::passes
