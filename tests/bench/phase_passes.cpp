// The passes: operations that were made before, from the head of the pipeline to nothing.
#include <benchmark/benchmark.h>

#include "tests/bench/part.hpp"
#include "tests/bench/programs.hpp"

namespace fagorc::bench {
namespace {

void all_passes(benchmark::State& state, const std::string& blocks) {
    Part part(blocks);
    const std::vector<operation::Operation> operations = part.operations();
    NullSink none;
    for (auto _ : state) {
        passes::Pipeline pipeline(part.environment(), none, {});
        for (const operation::Operation& o : operations) pipeline.head().push(o);
        pipeline.head().finish();
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * operations.size()));
}
BENCHMARK_CAPTURE(all_passes, lines, lines(10'000));
BENCHMARK_CAPTURE(all_passes, arcs, arcs(10'000));

}  // namespace
}  // namespace fagorc::bench
