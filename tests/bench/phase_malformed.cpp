// What a malformed block costs beside a good one: of a shape that is known, and of one that is parsed.
#include <benchmark/benchmark.h>

#include "frontend/structure/program_text.hpp"
#include "ir/diag/collection.hpp"
#include "ir/program/findings.hpp"
#include "tests/unit/frontend/text_side.hpp"

namespace fagorc::frontend {
namespace {

constexpr int blocks = 1'000;

struct Nowhere final : diag::Sink {
    void report(diag::Diagnostic) override {}
};

/// Reads one block again and again with what is wrong with it; `known`: its shape is parsed once, else each time.
void read(benchmark::State& state, const char* block, bool known) {
    std::string text;
    for (int i = 0; i < blocks; ++i) text.append(block) += '\n';
    const Scanner scanner(lathe());
    const auto maker = make_template_maker(lathe());
    ShapeCache shapes(*maker, known);
    Nowhere nowhere;
    for (auto _ : state) {
        ProgramText program({lathe(), scanner, shapes, nowhere, true}, {}, "part", text_of(text));
        program.check_unread(nowhere);
    }
    state.SetItemsProcessed(static_cast<std::int64_t>(state.iterations()) * blocks);
}

constexpr const char *move = "N10 G1 X20.5 Z-30 F100", *bad_move = "N10 G1 X20.5 Z-30 F100 (",
                     *statement = "(P1=SIN(P2)*3+COS(P4)/ABS(2)-5)",
                     *bad_statement = "(P1=SIN(P2)*3+COS(P4)/ABS(2)-*5)", *deep = "(P1=(/(-COS(*(/P1*SIN(-(/SIN(*)",
                     *strange = "N10 G1 X20.5 \xA0Z-30 F100";
BENCHMARK_CAPTURE(read, move_known, move, true);
BENCHMARK_CAPTURE(read, bad_move_known, bad_move, true);
BENCHMARK_CAPTURE(read, strange_character_known, strange, true);
BENCHMARK_CAPTURE(read, statement_known, statement, true);
BENCHMARK_CAPTURE(read, bad_statement_known, bad_statement, true);
BENCHMARK_CAPTURE(read, move_parsed, move, false);
BENCHMARK_CAPTURE(read, bad_move_parsed, bad_move, false);
BENCHMARK_CAPTURE(read, strange_character_parsed, strange, false);
BENCHMARK_CAPTURE(read, statement_parsed, statement, false);
BENCHMARK_CAPTURE(read, bad_statement_parsed, bad_statement, false);
BENCHMARK_CAPTURE(read, broken_at_once_parsed, deep, false);

}  // namespace
}  // namespace fagorc::frontend
