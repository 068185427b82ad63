#include "passes/compensation/compensation.hpp"

namespace fagorc::passes {
namespace {

class Compensation final : public Pass {
  public:
    using Pass::Pass;
    void push(const operation::Operation& o) override { emit(o); }
};

}  // namespace

std::unique_ptr<Pass> make_compensation(const Environment& environment, operation::Sink& next) {
    return std::make_unique<Compensation>(environment, next);
}

}  // namespace fagorc::passes
