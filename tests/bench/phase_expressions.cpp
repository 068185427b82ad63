// Expressions: the assignments of the parametric loop, each by itself and all in one block.
#include <benchmark/benchmark.h>

#include "passes/execute/expression.hpp"
#include "tests/bench/part.hpp"
#include "tests/bench/programs.hpp"

namespace fagorc::passes {
namespace {

constexpr int points = 1'000;

/// P0 counts the points and P1 is their angle, as in the loop. An item is an assignment.
void assign(benchmark::State& state, std::string_view assignments) {
    bench::Part part(fmt::format("({})\n", assignments));
    bench::NullSink none;
    Session session = part.session(none);
    IsoRunner iso(session);
    Variables variables(session, iso);
    Evaluator evaluator(session, variables);
    session.block = part.program().read(part.program().start());
    while (!std::holds_alternative<program::Statement>(session.block->shape->body))
        session.block = part.program().read(session.block->next);
    const auto& statement = std::get<program::Statement>(session.block->shape->body);
    const auto& list = std::get<program::Assign>(statement.what).list;
    double& point = *session.parameters.find(0);
    double& angle = *session.parameters.find(1);
    for (auto _ : state)
        for (int i = 0; i < points; ++i) {
            point = i;
            angle = i * 0.1;
            for (const program::Assignment& assignment : list) evaluator.assign(assignment);
        }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * points *
                            static_cast<std::int64_t>(list.size()));
}
BENCHMARK_CAPTURE(assign, product, "P1=P0*0.1");
BENCHMARK_CAPTURE(assign, sine, "P2=SIN P1");
BENCHMARK_CAPTURE(assign, sum, "P4=20+P3");
BENCHMARK_CAPTURE(assign, quotient_and_difference, "P5=0-P0/1000");
BENCHMARK_CAPTURE(assign, all_six, bench::assignments);

}  // namespace
}  // namespace fagorc::passes
