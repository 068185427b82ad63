// One program text: header, local subroutines, labels, subroutines, places, blocks that cannot be read.
#include "frontend/structure/program_text.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <random>

#include "frontend/structure/header.hpp"
#include "ir/diag/collection.hpp"
#include "ir/program/findings.hpp"
#include "tests/unit/frontend/text_side.hpp"

namespace fagorc::frontend {
namespace {

using diag::Id;
using program::Block;
using program::Cursor;

/// A program with everything that it needs.
struct Bench {
    explicit Bench(std::string text, bool loop_cache = true, bool shape_cache = true)
        : shapes(maker, shape_cache),
          program({lathe(), scanner, shapes, found, loop_cache}, {}, "000012.PIT", text_of(text)) {}

    /// The texts of the blocks from start() in line.
    std::vector<std::string> in_line() {
        std::vector<std::string> blocks;
        for (Cursor at = program.start(); const Block* block = program.read(at); at = block->next)
            blocks.emplace_back(block->text);
        return blocks;
    }
    std::vector<Id> ids() const {
        std::vector<Id> all;
        for (const auto& d : found.list()) all.push_back(d.id);
        return all;
    }
    std::uint32_t line_of(std::uint32_t label) {
        const auto at = program.label(label);
        return at ? at->line : 0;
    }

    PlainMaker maker;
    diag::Collection found;
    Scanner scanner{lathe()};
    ShapeCache shapes;
    ProgramText program;
};

using Blocks = std::vector<std::string>;

TEST(ProgramText, BlocksInLineWithTheirLines) {
    Bench b("X1\r\n\r\n; a remark\nX2 ; c\rX3");
    EXPECT_EQ(b.in_line(), (Blocks{"X1", "X2 ; c", "X3"}));
    EXPECT_EQ(b.program.read({5, 2})->here, (Cursor{17, 4}));  // silent lines are passed over
    EXPECT_EQ(b.program.blocks_read(), 4u);
}

TEST(ProgramText, AnEmptyTextHasNoBlocks) {
    for (const char* text : {"", "\n", "; a remark", "\xEF\xBB\xBF"})
        EXPECT_EQ(Bench(text).in_line(), Blocks{}) << text;
}

TEST(ProgramText, AByteOrderMarkIsNoBlock) {
    Bench b("\xEF\xBB\xBF%A,MX,\nX1\n");
    EXPECT_EQ(b.in_line(), Blocks{"X1"});
    EXPECT_EQ(b.program.header().comment, "A");
}

TEST(ProgramText, TheNumberIsTheFileName) {
    EXPECT_EQ(program_number("000012.PIT"), 12u);
    EXPECT_EQ(program_number("a/b/999999.pim"), 999999u);
    for (const char* name : {"12.PIT", "000012.TXT", "00012a.PIT", "0000012.PIT", "000012PIT", ""})
        EXPECT_FALSE(program_number(name)) << name;
}

// 8055 T 1.1.
TEST(ProgramText, HeaderLines) {
    const auto read = [](const char* line, bool expected) {
        bool well_formed = !expected;
        const program::Header h = read_header(line, well_formed);
        EXPECT_EQ(well_formed, expected) << line;
        return h;
    };
    const auto home = read("%HOME,-X,", true);
    EXPECT_EQ(home.comment, "HOME");
    EXPECT_TRUE(home.present && home.executable);
    EXPECT_FALSE(home.modifiable || home.oem || home.hidden);
    EXPECT_FALSE(read("%,M-,", true).executable);
    const auto all = read("% ,OHMX,", true);
    EXPECT_TRUE(all.oem && all.hidden && all.modifiable && all.executable);
    EXPECT_EQ(read("%12345678901234567890,MX,", true).comment.size(), 20u);
    read("%123456789012345678901,MX,", false);
    read("%A,MXQ,", false);
    read("%A,MX", false);
    const auto bare = read("%A", false);
    EXPECT_TRUE(bare.modifiable && bare.executable);
}

TEST(ProgramText, AMalformedHeaderIsOneFinding) {
    Bench b("%A,Q,\r\nX1");
    EXPECT_EQ(b.in_line(), Blocks{"X1"});
    ASSERT_EQ(b.ids(), std::vector<Id>{Id::header_malformed});
    EXPECT_EQ(b.found.list()[0].place.end_column, 6u);
    Bench without("X1");
    EXPECT_FALSE(without.program.header().present);
    EXPECT_TRUE(without.program.header().executable);
    EXPECT_TRUE(without.found.list().empty());
}

TEST(ProgramText, TheEndOfTapeSignEndsTheText) {
    EXPECT_EQ(Bench("X1\n%").in_line(), Blocks{"X1"});
    EXPECT_EQ(Bench("X1\n% \r\n\r\n").in_line(), Blocks{"X1"});
    EXPECT_EQ(Bench("X1\n%\nX2").in_line(), (Blocks{"X1", "%", "X2"}));  // no end: the grammar refuses it
}

// 8055 T 2.2: local subroutines, then a line that begins with %, then the main part.
TEST(ProgramText, TheMainPartBeginsBehindTheMark) {
    Bench b("%P,MX,\n; locals\n(LSUB 3)\nX1\n(RET)\n% main\nX2\n(SUB 4)\n(RET)\n");
    EXPECT_EQ(b.program.start().line, 7u);
    EXPECT_EQ(b.in_line(), (Blocks{"X2", "(SUB 4)", "(RET)"}));
    const auto* local = b.program.subroutine(3, true);
    ASSERT_TRUE(local);
    EXPECT_EQ(local->begin.line, 3u);
    EXPECT_EQ(local->body.line, 4u);
    EXPECT_FALSE(b.program.subroutine(3, false));
    EXPECT_FALSE(b.program.subroutine(4, true));
    EXPECT_EQ(b.program.subroutine(4, false)->begin.line, 8u);
    EXPECT_EQ(b.program.subroutine(3, true), local);  // it stays where it is
}

TEST(ProgramText, WithoutLocalSubroutinesNothingIsSkipped) {
    Bench b("X1\n%\nX2");
    EXPECT_EQ(b.program.start().line, 1u);
    Bench unmarked("(LSUB 3)\n(RET)\nX1");
    EXPECT_EQ(unmarked.program.start().line, 1u);
}

TEST(ProgramText, TheFirstOfEqualLabelsCounts) {
    Bench b("N30 X1\nN0010 X2\nN10 X3\nN30 X4\nN20 X5\nN0 X6\n");
    EXPECT_EQ(b.line_of(30), 1u);
    EXPECT_EQ(b.line_of(10), 2u);
    EXPECT_EQ(b.line_of(20), 5u);
    EXPECT_EQ(b.line_of(0), 6u);
    EXPECT_EQ(b.line_of(40), 0u);
    EXPECT_EQ(b.line_of(30 + 64), 0u);  // shares the place of a recent jump
    EXPECT_EQ(b.line_of(30), 1u);
}

TEST(ProgramText, AMillionLabelsAreQuickAndSmall) {
    constexpr std::uint32_t count = 1'000'000;
    const auto label = [](std::uint64_t line) {
        return static_cast<std::uint32_t>(line * 7919 % 1'000'003);
    };  // a prime
    std::string text;
    for (std::uint32_t i = 0; i < count; ++i) text += "N" + std::to_string(label(i)) + " X1\n";
    Bench b(std::move(text));
    const auto begin = std::chrono::steady_clock::now();
    EXPECT_FALSE(b.program.label(99'999'999));
    std::mt19937 random(1);
    for (int i = 0; i < 10'000; ++i) {
        const auto n = static_cast<std::uint32_t>(random() % count);
        ASSERT_EQ(b.line_of(label(n)), n + 1);
    }
    // A search that looks at all labels, or sorts them each time, would take minutes.
    EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(60));
}

TEST(LabelTable, FindsTheFirstInAnyOrder) {
    std::mt19937 random(2);
    for (const std::uint32_t range : {10u, 1000u, 100'000u}) {
        LabelTable table;
        std::map<std::uint32_t, std::uint32_t> expected;
        for (std::uint32_t line = 1; line <= 5000; ++line) {
            const std::uint32_t label = line < 2000 ? line : static_cast<std::uint32_t>(random() % range);
            table.add(label, line);
            expected.emplace(label, line);
            const auto asked = static_cast<std::uint32_t>(random() % range);
            const auto at = expected.find(asked);
            ASSERT_EQ(table.find(asked), at == expected.end() ? std::nullopt : std::optional(at->second));
        }
    }
}

TEST(ProgramText, PlacesOfLines) {
    std::string text = "%P,MX,\n";
    std::vector<std::size_t> starts{0, text.size()};
    for (int i = 0; i < 2000; ++i) {
        text += i % 7 ? "X" + std::to_string(i) + "\r\n" : "\n";
        starts.push_back(text.size());
    }
    Bench b(text);
    const auto check = [&](std::uint32_t line) {
        const diag::Place p = b.program.place_of_line(line);
        EXPECT_EQ(p.block, starts[line - 1]) << line;
        EXPECT_EQ(p.line, line);
        EXPECT_EQ(p.column, 1u);
        EXPECT_EQ(p.end_column, text.find_first_of("\r\n", starts[line - 1]) - starts[line - 1] + 1) << line;
    };
    for (std::uint32_t line : {1u, 2u, 1500u, 3u, 1999u, 700u}) check(line);
    EXPECT_FALSE(b.program.label(1));  // indexes
    for (std::uint32_t line : {1u, 2u, 1500u, 3u, 1999u, 700u, 256u, 257u, 511u}) check(line);
}

TEST(ProgramText, ABlockBeyondTheLimitIsOneFindingAndTheNextIsRead) {
    const std::string huge(70'000, 'X');
    Bench b("X1\n" + huge + "\nX2\n");
    EXPECT_EQ(b.in_line().size(), 3u);
    const Block* block = b.program.read({3, 2});
    ASSERT_TRUE(block->shape->broken);
    program::report_findings(b.program, *block, b.found);
    ASSERT_EQ(b.ids(), std::vector<Id>{Id::block_too_long});
    EXPECT_EQ(b.found.list()[0].arguments.at(0).plain, "65536");
    EXPECT_EQ(b.program.read(block->next)->text, "X2");
}

// 8055 T 2.1.1: 0..99999999.
TEST(ProgramText, LabelsHaveARange) {
    Bench b("N99999999 X1\nN100000000 X2\nN-5 X3\nN1e30\n");
    b.program.check_unread(b.found);
    EXPECT_EQ(b.ids(), (std::vector<Id>{Id::label_too_large, Id::label_too_large}));
    EXPECT_EQ(b.found.list()[0].place.line, 2u);
    EXPECT_EQ(b.found.list()[0].place.column, 1u);
    EXPECT_EQ(b.found.list()[0].place.end_column, 11u);
    EXPECT_EQ(b.line_of(99'999'999), 1u);
    EXPECT_EQ(b.line_of(5), 0u);
}

TEST(ProgramText, BlocksThatWereNotReadAreChecked) {
    Bench b("X1\n[\nX2\n]\nX3\n");
    const Block* first = b.program.read(b.program.start());
    const Block* second = b.program.read(first->next);
    ASSERT_TRUE(second->shape->broken);
    b.program.check_unread(b.found);  // what was read in line has been told by the reader
    ASSERT_EQ(b.ids(), std::vector<Id>{Id::strange_character});
    EXPECT_EQ(b.found.list()[0].place.line, 4u);
}

TEST(ProgramText, NumbersOfSubroutinesAreChecked) {
    Bench b("X1\n(SUB 10000)\n(RET)\n(SUB 5)\n(RET)\n(SUB 5)\n(RET)\n");
    EXPECT_FALSE(b.program.label(1));
    b.program.check_unread(b.found);
    EXPECT_EQ(b.ids(), (std::vector<Id>{Id::subroutine_number_out_of_range, Id::subroutine_repeated}));
    EXPECT_EQ(b.program.subroutine(5, false)->begin.line, 4u);
    Bench oem("%P,OMX,\n(SUB 10000)\n(RET)\n");
    oem.program.check_unread(oem.found);
    EXPECT_EQ(oem.ids(), std::vector<Id>{});
}

TEST(ProgramText, ALoopReadsTheSameBlocksWithAndWithoutTheCaches) {
    const std::string text = "X1\nN10 X2 Z3\n; a remark\nX4 ; tail\n(MSG \"a\")\n";
    const auto trace = [&](bool loop_cache, bool shape_cache) {
        Bench b(text, loop_cache, shape_cache);
        std::string seen;
        for (int round = 0; round < 4; ++round)
            for (Cursor at = round ? *b.program.label(10) : b.program.start(); const Block* block = b.program.read(at);
                 at = block->next) {
                seen += std::string(block->text) + "@" + std::to_string(block->here.offset);
                for (const auto& q : block->slots) seen += " " + std::to_string(q.value) + ":" + std::to_string(q.at);
                seen += "\n";
            }
        EXPECT_EQ(b.program.blocks_read(), 4u + 3 * 3u);
        EXPECT_EQ(b.maker.calls, b.shapes.shapes());
        return seen;
    };
    const std::string expected = trace(false, false);
    EXPECT_EQ(trace(true, true), expected);
    EXPECT_EQ(trace(true, false), expected);
    EXPECT_EQ(trace(false, true), expected);
}

TEST(ProgramText, RebindingReadsAChangedBlockAtTheSamePlace) {
    Bench b("X1\nGP1 X2\nX3\n");
    const Block* original = b.program.read({3, 2});
    const Block* bound = b.program.rebind(*original, "G3 X2", b.found);
    ASSERT_TRUE(bound);
    EXPECT_EQ(bound->text, "G3 X2");
    EXPECT_EQ(bound->here, original->here);
    EXPECT_EQ(bound->next, original->next);
    EXPECT_EQ(original->text, "GP1 X2");
    EXPECT_EQ(original->slots[0].value, 1);
    EXPECT_FALSE(b.program.rebind(*original, "G3 [", b.found));
    ASSERT_EQ(b.ids(), std::vector<Id>{Id::strange_character});
    EXPECT_EQ(b.found.list()[0].place.line, 2u);
}

}  // namespace
}  // namespace fagorc::frontend
