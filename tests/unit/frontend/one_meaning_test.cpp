// A shape has one meaning: the caches of shapes and of decoded blocks change nothing but the time.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <string>
#include <vector>

#include "frontend/controls/controls.hpp"
#include "frontend/frontend.hpp"
#include "tests/unit/frontend/describe.hpp"

namespace fagorc::frontend {
namespace {

struct Findings final : diag::Sink {
    void report(diag::Diagnostic d) override {
        list += std::to_string(static_cast<int>(d.id)) + '@' + std::to_string(d.place.line) + ':' +
                std::to_string(d.place.column) + '-' + std::to_string(d.place.end_column);
        for (const auto& a : d.arguments) list += " " + std::string(a.in(Language::english));
        list += '\n';
    }
    std::string list;
};

/// All that one way of reading finds in a text.
struct Reading {
    std::vector<std::string> blocks;  ///< of each pass over the text, one after the other
    std::string findings;
    Statistics statistics;
};

std::string seen(program::Program& program, const program::Block& block) {
    std::string out = std::to_string(block.here.line) + ' ' + std::string(block.text) + '\n' + describe(*block.shape);
    for (const program::Quantity& q : block.slots)
        out += "\nslot " + std::to_string(q.value) + '@' + std::to_string(q.at) + '+' + std::to_string(q.length) + ' ' +
               std::to_string(q.integer_digits) + '.' + std::to_string(q.decimals);
    for (const program::PlacedToken& t : program.tokens(block))
        out += "\ntoken " + std::to_string(static_cast<int>(t.kind)) + ':' + std::to_string(t.payload) + '@' +
               std::to_string(t.at);
    return out;
}

/// Reads a text three times from its start, as a loop does.
Reading read(const std::string& text, Options options) {
    Findings findings;
    Workspace workspace(*dialect("8055"), findings, options);
    program::Program& program = workspace.add("part", text);
    Reading all;
    for (int pass = 0; pass < 3; ++pass)
        for (auto at = program.start(); const program::Block* block = program.read(at); at = block->next)
            all.blocks.push_back(seen(program, *block));
    program.check_unread(findings);
    all.findings = findings.list;
    all.statistics = workspace.statistics();
    return all;
}

void expect_one_meaning(const std::string& text, const std::string& name) {
    const Reading plain = read(text, {.shape_cache = false, .loop_cache = false});
    const Reading shapes = read(text, {.shape_cache = true, .loop_cache = false});
    const Reading loops = read(text, {.shape_cache = true, .loop_cache = true});
    for (const Reading* r : {&shapes, &loops}) {
        ASSERT_EQ(r->blocks.size(), plain.blocks.size()) << name;
        for (std::size_t i = 0; i < plain.blocks.size(); ++i) ASSERT_EQ(r->blocks[i], plain.blocks[i]) << name;
        EXPECT_EQ(r->findings, plain.findings) << name;
        EXPECT_EQ(r->statistics.shapes, r->statistics.parser_calls) << name;
        EXPECT_EQ(r->statistics.blocks, plain.statistics.blocks) << name;
    }
    EXPECT_LE(shapes.statistics.shapes, plain.statistics.shapes) << name;
}

/// Blocks of pieces that the language has, and now and then of pieces that it has not, in any order.
std::string random_program(unsigned seed, int blocks) {
    static const char* const pieces[] = {"G1",
                                         "G0 ",
                                         "G02",
                                         "G",
                                         "GP1",
                                         "X",
                                         "Z-",
                                         "X-P3",
                                         "10",
                                         "3 0",
                                         ".5",
                                         "-12.345",
                                         "F.2",
                                         "S1500",
                                         "T2.20",
                                         "D4",
                                         "M3",
                                         "M30",
                                         "M",
                                         "N10",
                                         "N",
                                         "/",
                                         "/2",
                                         ";rest (X",
                                         "(",
                                         ")",
                                         "IF",
                                         "P100",
                                         "EQ",
                                         "GT 5",
                                         "GOTO",
                                         "N60",
                                         "P1=P2+1",
                                         "=",
                                         ",",
                                         "SIN",
                                         "\"a;b)\"",
                                         "\"open",
                                         "MSG",
                                         "RPT N1,N2",
                                         "PCALL 5,A1",
                                         "ORGX54",
                                         "ASINX",
                                         "$FC",
                                         "$",
                                         "x",
                                         "g1",
                                         "%",
                                         "\xC2\xA0",
                                         "\xE2\x88\x92",
                                         "[",
                                         "\xFF",
                                         "(P1=2*(P3-1))",
                                         "(WRITE G1 XP1)",
                                         "(RET)",
                                         "(SUB 3)",
                                         " ",
                                         "\t"};
    std::mt19937 random(seed);
    std::string text = "%RANDOM,MX,\n";
    for (int b = 0; b < blocks; ++b) {
        for (auto n = random() % 7; n-- > 0;) text += pieces[random() % std::size(pieces)];
        text += random() % 3 ? "\n" : random() % 2 ? "\r\n" : "\r";
    }
    return text;
}

TEST(OneMeaning, OfRandomBlocks) {
    for (unsigned seed = 1; seed <= 40; ++seed)
        expect_one_meaning(random_program(seed, 60), "seed " + std::to_string(seed));
}

TEST(OneMeaning, ABlockWhoseShapeIsKnownIsNotParsed) {
    std::string text;
    for (int i = 1; i <= 500; ++i) text += "N" + std::to_string(i) + " G1 X" + std::to_string(i) + ".5 Z-1 F0.25\n";
    const Reading r = read(text, {});
    EXPECT_EQ(r.statistics.blocks, 1500u);
    EXPECT_EQ(r.statistics.parser_calls, 1u);
    // One more: the first block is looked at to see whether local subroutines stand there.
    EXPECT_EQ(read(text, {.shape_cache = false, .loop_cache = true}).statistics.parser_calls, 1501u);
}

/// The programs below a folder beside the specification, where they are.
std::vector<std::filesystem::path> programs(const char* folder) {
    const char* given = std::getenv("FAGORC_SPECIFICATION");
    const std::filesystem::path root = std::filesystem::path(given ? given : "../shared/spec").parent_path() / folder;
    std::vector<std::filesystem::path> all;
    std::error_code none;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(root, none)) {
        const auto suffix = entry.path().extension();
        if (suffix == ".PIM" || suffix == ".PIT" || suffix == ".pit") all.push_back(entry.path());
    }
    return all;
}

class ProgramsOf : public testing::TestWithParam<const char*> {};

TEST_P(ProgramsOf, HaveOneMeaning) {
    const auto all = programs(GetParam());
    if (all.empty()) GTEST_SKIP() << "the programs are not here";
    for (const auto& path : all) {
        std::ifstream in(path, std::ios::binary);
        std::string text(std::istreambuf_iterator<char>(in), {});
        text.resize(std::min<std::size_t>(text.size(), 20'000));  // each block of the plain way costs a parse
        expect_one_meaning(text, path.string());
    }
}

INSTANTIATE_TEST_SUITE_P(OneMeaning, ProgramsOf,
                         testing::Values("real", "examples/8055-core", "examples/8055-language"));

}  // namespace
}  // namespace fagorc::frontend
