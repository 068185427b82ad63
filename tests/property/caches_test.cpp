// The caches of the front end change nothing: every block has the same template, numbers and findings with the shape
// cache and the cache of decoded blocks on and off. Over random blocks, and over the example and real programs where
// they are there.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <random>
#include <string>

#include "frontend/controls/controls.hpp"
#include "frontend/frontend.hpp"
#include "ir/diag/catalogue.hpp"
#include "ir/diag/collection.hpp"
#include "ir/program/describe.hpp"
#include "ir/program/findings.hpp"

namespace fagorc {
namespace {

const control::Dialect& lathe() {
    return *frontend::dialect("8055");
}

void append(std::string& told, const diag::Collection& found) {
    for (const diag::Diagnostic& d : found.list())
        told += "  " + std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + "-" +
                std::to_string(d.place.end_column) + " " + std::string(diag::row(d.id).name) + " " +
                diag::message(d, Language::english) + "\n";
}

/// All that a program's blocks are, read `rounds` times over as a loop reads them.
std::string evaluation(program::Program& program, const diag::Collection& found, int rounds) {
    std::string told;
    for (int round = 0; round < rounds; ++round)
        for (program::Cursor at = program.start(); const program::Block* block = program.read(at); at = block->next) {
            told += std::to_string(block->here.line) + " " + describe(*block->shape, lathe()) + " |";
            for (const program::Quantity& q : block->slots)
                told += " " + std::to_string(q.value) + "@" + std::to_string(q.at) + "+" + std::to_string(q.length) +
                        ":" + std::to_string(q.integer_digits) + "." + std::to_string(q.decimals);
            told += "\n";
            diag::Collection own;
            program::report_findings(program, *block, own);
            append(told, own);
        }
    append(told, found);
    return told;
}

/// Evaluates with all four settings of the caches and compares; `open` puts the program into a workspace.
template <class Open>
void expect_same(Open open, const std::string& name) {
    std::optional<std::string> expected;
    for (const bool shape_cache : {false, true})
        for (const bool loop_cache : {false, true}) {
            diag::Collection found;
            frontend::Workspace workspace(lathe(), found, {shape_cache, loop_cache});
            program::Program* program = open(workspace);
            const std::string told = program ? evaluation(*program, found, 3) : "unreadable";
            const frontend::Statistics s = workspace.statistics();
            EXPECT_EQ(s.shapes, s.parser_calls) << name;
            if (!expected)
                expected = told;
            else
                EXPECT_EQ(told, *expected) << name << ", shape cache " << shape_cache << ", loop cache " << loop_cache;
        }
}

/// Blocks made of pieces of the language, most of them sound, some not.
std::string random_program(std::mt19937& random) {
    static const char* const pieces[] = {"N10 ",
                                         "N20",
                                         "/ ",
                                         "/2 ",
                                         "G1 ",
                                         "G 0 1",
                                         "G90 ",
                                         "G2",
                                         "GP1 ",
                                         "X10 ",
                                         "X 3 0 ",
                                         "X-P3 ",
                                         "XP5",
                                         "Z-1.25",
                                         "z2 ",
                                         "I1 K-2 ",
                                         "R5.5 ",
                                         "F200 ",
                                         "S1000 ",
                                         "T2.2 ",
                                         "D2 ",
                                         "M3 ",
                                         "M30",
                                         "M",
                                         "G",
                                         "G36 R10 ",
                                         "Q45 ",
                                         " ; remark (P1",
                                         "(P1=P2+SIN(P3)*4)",
                                         "(P1=1,P2=2)",
                                         "(IF P1 EQ $F GOTO N10)",
                                         "(GOTO N20",
                                         "(CALL 5)",
                                         "(PCALL 5,A1,P2=3)",
                                         "(MSG \"a;)\")",
                                         "(MSG \"open",
                                         "(WRITE G1 X$P1 (a))",
                                         "(RPT N10,N20) N3",
                                         "(SUB 5)",
                                         "(RET)",
                                         ")",
                                         "(",
                                         "\xC2\xA0",
                                         "\xE9",
                                         "[",
                                         "%",
                                         ",",
                                         "=",
                                         "1.2.3",
                                         ".",
                                         "-",
                                         "\t",
                                         "ASINX",
                                         "(P1=ASINX)",
                                         "(P1=ORGX54)",
                                         "(LL9505)"};
    const auto below = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
    std::string text = "X1\n";  // no header
    for (std::size_t blocks = 30; blocks > 0; --blocks) {
        for (std::size_t n = below(6); n > 0; --n) text += pieces[below(std::size(pieces))];
        text += below(4) ? "\n" : below(2) ? "\r\n" : "\r";
    }
    return text;
}

TEST(Caches, ChangeNothingOverRandomBlocks) {
    std::mt19937 random(41);
    for (int i = 0; i < 60; ++i) {
        const std::string text = random_program(random);
        expect_same([&](frontend::Workspace& w) { return &w.add("part", text); }, text);
        if (HasFailure()) return;
    }
}

/// Programs of a folder beside the project, or of the environment's.
std::size_t sweep(const char* variable, const char* beside) {
    const char* given = std::getenv(variable);
    const std::filesystem::path folder = given ? given : beside;
    std::error_code none;
    std::size_t programs = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder, none)) {
        const std::string suffix = entry.path().extension().string();
        if (suffix != ".pit" && suffix != ".PIT" && suffix != ".pim" && suffix != ".PIM") continue;
        ++programs;
        expect_same([&](frontend::Workspace& w) { return w.open(entry.path().string()); }, entry.path().string());
    }
    return programs;
}

TEST(Caches, ChangeNothingOverTheExamples) {
    if (sweep("FAGORC_EXAMPLES", "../shared/examples") == 0) GTEST_SKIP() << "the example programs are not here";
}

TEST(Caches, ChangeNothingOverRealPrograms) {
    if (sweep("FAGORC_REAL", "../shared/real") == 0) GTEST_SKIP() << "the real programs are not here";
}

}  // namespace
}  // namespace fagorc
