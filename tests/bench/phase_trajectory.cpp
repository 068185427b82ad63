// The trajectory file: written to memory, opened and walked as a controller does, and checked.
#include <benchmark/benchmark.h>

#include "backends/trajectory/writer.hpp"
#include "runtime/player/moves.hpp"
#include "runtime/player/verify.hpp"
#include "tests/bench/part.hpp"
#include "tests/bench/programs.hpp"

namespace fagorc::bench {
namespace {

constexpr int blocks = 10'000;

void write_to(backends::Output& output, Part& part, const std::vector<operation::Operation>& moves) {
    const auto writer = backends::make_trajectory_writer(part.job(), output);
    for (const operation::Operation& move : moves) writer->push(move);
    writer->finish();
}

/// The file of a program.
std::vector<std::byte> file_of(const std::string& text) {
    Part part(text);
    backends::MemoryOutput output;
    write_to(output, part, part.moves());
    return output.bytes();
}

void per_move(benchmark::State& state, std::size_t moves, std::size_t bytes) {
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations() * moves));
    state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * bytes));
}

void write_file(benchmark::State& state, const std::string& text) {
    Part part(text);
    const std::vector<operation::Operation> moves = part.moves();
    std::size_t bytes = 0;
    for (auto _ : state) {
        backends::MemoryOutput output;
        write_to(output, part, moves);
        bytes = output.bytes().size();
    }
    per_move(state, moves.size(), bytes);
}
BENCHMARK_CAPTURE(write_file, lines, lines(blocks));
BENCHMARK_CAPTURE(write_file, arcs, arcs(blocks));

void play_file(benchmark::State& state, const std::string& text) {
    const std::vector<std::byte> file = file_of(text);
    std::uint64_t moves = 0;
    for (auto _ : state) {
        player::Trajectory trajectory;
        if (trajectory.open(file) != player::Status::ok) return state.SkipWithError("the file cannot be opened");
        player::MoveReader reader(trajectory);
        for (moves = 0; const player::Move* move = reader.next(); ++moves) benchmark::DoNotOptimize(move->end.data());
    }
    per_move(state, moves, file.size());
}
BENCHMARK_CAPTURE(play_file, lines, lines(blocks));
BENCHMARK_CAPTURE(play_file, arcs, arcs(blocks));

void check_file(benchmark::State& state) {
    const std::vector<std::byte> file = file_of(lines(blocks));
    for (auto _ : state)
        if (player::verify(file).status != player::Status::ok) return state.SkipWithError("the file is not sound");
    per_move(state, blocks, file.size());
}
BENCHMARK(check_file);

}  // namespace
}  // namespace fagorc::bench
