#include "passes/contour/contour.hpp"

namespace fagorc::passes {
namespace {

class Contour final : public Pass {
  public:
    using Pass::Pass;
    void push(const operation::Operation& o) override { emit(o); }
};

}  // namespace

std::unique_ptr<Pass> make_contour(const Environment& environment, operation::Sink& next) {
    return std::make_unique<Contour>(environment, next);
}

}  // namespace fagorc::passes
