#include "passes/pipeline.hpp"

#include <span>

#include "passes/axes/axes.hpp"
#include "passes/check/check.hpp"
#include "passes/compensation/compensation.hpp"
#include "passes/contour/contour.hpp"
#include "passes/cycles/cycles.hpp"
#include "passes/verifier.hpp"

namespace fagorc::passes {
namespace {

struct Row {
    std::string_view name;
    std::unique_ptr<Pass> (*make)(const Environment&, operation::Sink& next);
};

// The order is the control's own (docs/order.md): corners belong to the programmed path, so they precede the nose; a
// cycle's profile may hold corners; the nose radius is neither scaled nor shifted; limits count from the machine zero.
constexpr Row rows[] = {
    {"contour", make_contour}, {"cycles", make_cycles}, {"compensation", make_compensation},
    {"axes", make_axes},       {"check", make_check},
};

}  // namespace

Pipeline::Pipeline(const Environment& environment, operation::Sink& tail, const Options& options) : head_(&tail) {
    std::size_t count = std::size(rows);
    for (std::size_t i = 0; i < std::size(rows); ++i)
        if (rows[i].name == options.stop_after) count = i + 1;
    if (options.stop_after == before_all) count = 0;
    const auto add = [this](std::unique_ptr<Pass> stage) {
        head_ = stage.get();
        stages_.push_back(std::move(stage));
    };
    for (std::size_t i = count; i-- > 0;) {
        if (options.verify) add(make_verifier(environment, *head_, rows[i].name));
        add(rows[i].make(environment, *head_));
    }
    if (options.verify) add(make_verifier(environment, *head_, before_all));
}

Pipeline::~Pipeline() = default;

operation::Sink& Pipeline::head() {
    return *head_;
}

std::vector<std::string_view> Pipeline::names() {
    std::vector<std::string_view> all;
    for (const Row& r : rows) all.push_back(r.name);
    return all;
}

}  // namespace fagorc::passes
