// Phases of the text side: scan, shape look-up, whole blocks.
#include <benchmark/benchmark.h>

#include "frontend/scan/scanner.hpp"
#include "frontend/structure/program_text.hpp"
#include "ir/diag/collection.hpp"
#include "tests/bench/programs.hpp"
#include "tests/unit/frontend/text_side.hpp"

namespace fagorc::frontend {
namespace {

constexpr int blocks = 10'000;

void per_block(benchmark::State& state, std::size_t bytes) {
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * blocks);
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(bytes));
}

void scan(benchmark::State& state) {
    const std::string text = bench::lines(blocks);
    const Scanner scanner(lathe());
    Scan room(lathe().limits.block_bytes);
    for (auto _ : state)
        for (std::size_t at = 0; at < text.size();) {
            at += scanner.scan(text.data() + at, room).next;
            benchmark::DoNotOptimize(room.slots());
        }
    per_block(state, text.size());
}
BENCHMARK(scan);

/// Neighbouring blocks of one shape (0) or of two in turn (1).
void look_up(benchmark::State& state) {
    PlainMaker maker;
    ShapeCache shapes(maker, true);
    program::BlockTemplate own;
    const std::string keys[] = {"N#\x80\x01X#Z#F#", state.range(0) ? "N#\x80\x02X#Z#I#K#" : "N#\x80\x01X#Z#F#"};
    for (auto _ : state)
        for (int i = 0; i < blocks; ++i) benchmark::DoNotOptimize(&shapes.find(keys[i % 2], own));
    per_block(state, 0);
}
BENCHMARK(look_up)->Arg(0)->Arg(1);

/// Blocks in line, without what their shapes mean.
void read(benchmark::State& state) {
    const std::string text = bench::lines(blocks);
    const Scanner scanner(lathe());
    PlainMaker maker;
    ShapeCache shapes(maker, true);
    diag::Collection found;
    for (auto _ : state) {
        ProgramText program({lathe(), scanner, shapes, found, true}, {}, "part", text_of(text));
        for (program::Cursor at = program.start(); const program::Block* block = program.read(at); at = block->next)
            benchmark::DoNotOptimize(block->slots.data());
    }
    per_block(state, text.size());
}
BENCHMARK(read);

}  // namespace
}  // namespace fagorc::frontend
