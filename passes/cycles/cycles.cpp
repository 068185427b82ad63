#include "passes/cycles/cycles.hpp"

namespace fagorc::passes {
namespace {

class Cycles final : public Pass {
  public:
    using Pass::Pass;
    void push(const operation::Operation& o) override { emit(o); }
};

}  // namespace

std::unique_ptr<Pass> make_cycles(const Environment& environment, operation::Sink& next) {
    return std::make_unique<Cycles>(environment, next);
}

}  // namespace fagorc::passes
