// Execution: whole programs, read and executed into nothing. An item is a block, of the loops a point.
#include <benchmark/benchmark.h>

#include "tests/bench/part.hpp"
#include "tests/bench/programs.hpp"

namespace fagorc::bench {
namespace {

constexpr int count = 10'000;

/// The shapes are known from the first execution on, as in a long program.
void execute(benchmark::State& state, const std::string& blocks) {
    Part part(blocks);
    NullSink none;
    for (auto _ : state) part.execute(none);
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * count);
}
BENCHMARK_CAPTURE(execute, lines, lines(count));
BENCHMARK_CAPTURE(execute, arcs, arcs(count));
BENCHMARK_CAPTURE(execute, loop_of_six_blocks, loop(count, false));
BENCHMARK_CAPTURE(execute, loop_of_one_block, loop(count, true));

}  // namespace
}  // namespace fagorc::bench
