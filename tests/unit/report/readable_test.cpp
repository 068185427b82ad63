// Bytes of programs as printable UTF-8, and carets under the right columns.
#include "tools/fagorc/report/readable.hpp"

#include <gtest/gtest.h>

#include "tools/fagorc/report/snippet.hpp"

namespace fagorc::report {
namespace {

using namespace std::string_literals;

TEST(Readable, LeavesUtf8AsItIs) {
    EXPECT_EQ(readable("G1 X10 ; Ébauche"), "G1 X10 ; Ébauche");
}

// E9 is é in Latin-1; 82 is é in CP850 and no character in Latin-1.
TEST(Readable, ReadsLatin1AndCp850) {
    EXPECT_EQ(readable("; \xC9"
                       "bauche \xE9"),
              "; Ébauche é");
    EXPECT_EQ(readable("; pi\x82"
                       "ce \x85 \xE1"),
              "; piéce à ß");
}

TEST(Readable, ShowsControlCharactersAndNeverPassesAnEscape) {
    EXPECT_EQ(readable("a\x1b[31mb\x7f"), "a␛[31mb␡");
    EXPECT_EQ(readable(std::string_view("\0x", 2)), "␀x");
}

// The encodings that UTF-8 forbids: overlong, surrogate, beyond U+10FFFF, cut short.
TEST(Readable, TakesNoMalformedUtf8) {
    for (std::string_view bad : {"\xC0\xAF", "\xED\xA0\x80", "\xF4\x90\x80\x80", "\xE2\x82"}) {
        const std::string shown = readable(bad);
        EXPECT_EQ(cells(bad).size(), bad.size());
        EXPECT_EQ(readable(shown), shown) << "the result is UTF-8 and stays what it is";
    }
}

TEST(Readable, CountsCodePoints) {
    EXPECT_EQ(code_points_before("é X", 2), 1u);
    EXPECT_EQ(code_points_before("é X", 3), 2u);
    EXPECT_EQ(code_points_before("\xE9 X", 2), 2u);
    EXPECT_EQ(code_points_before("X", 3), 3u) << "places after the end of the line count on";
}

TEST(SnippetTest, CaretsStandUnderTheWord) {
    const Snippet s = snippet("G90 G01 V10 F100", 9, 12, 80);
    EXPECT_EQ(s.text, "G90 G01 V10 F100");
    EXPECT_EQ(s.indent.size(), 8u);
    EXPECT_EQ(s.carets, 3u);
}

TEST(SnippetTest, TabsAreExpandedBeforeAndUnderTheWord) {
    const Snippet s = snippet("G1\tX10\tV5", 8, 10, 80);
    EXPECT_EQ(s.text, "G1  X10 V5");
    EXPECT_EQ(s.indent.size(), 8u);
    EXPECT_EQ(s.carets, 2u);
    EXPECT_EQ(snippet("X1\tY", 3, 4, 80).carets, 2u) << "the tab itself is marked";
}

TEST(SnippetTest, MultiByteAndWideCharactersCountByTheirColumns) {
    EXPECT_EQ(snippet("éé V1", 6, 8, 80).indent.size(), 3u);
    EXPECT_EQ(snippet("\xE9\xE9 V1", 4, 6, 80).indent.size(), 3u);
    const Snippet wide = snippet("X１０", 2, 8, 80);  // two full-width digits of three bytes and two columns
    EXPECT_EQ(wide.indent.size(), 1u);
    EXPECT_EQ(wide.carets, 4u);
}

TEST(SnippetTest, AnEmptyPieceAndTheEndOfTheLineGetOneCaret) {
    EXPECT_EQ(snippet("G1 X", 5, 5, 80).carets, 1u);
    EXPECT_EQ(snippet("G1 X", 5, 5, 80).indent.size(), 4u);
    EXPECT_EQ(snippet("G1 X", 0, 0, 80).indent.size(), 0u);
    EXPECT_EQ(snippet("", 1, 1, 80).carets, 1u);
    EXPECT_EQ(snippet("G1", 90, 99, 80).indent.size(), 2u);
}

TEST(SnippetTest, ALongLineIsCutAroundTheWord) {
    const std::string line = std::string(300, 'a') + "V12" + std::string(300, 'b');
    const Snippet s = snippet(line, 301, 304, 60);
    EXPECT_EQ(s.text.size(), 60u);
    EXPECT_EQ(s.text.substr(0, 3), "...");
    EXPECT_EQ(s.text.substr(57), "...");
    EXPECT_EQ(s.text.substr(s.indent.size(), s.carets), "V12");
}

TEST(SnippetTest, AWordAtEitherEndOfALongLineIsShown) {
    const std::string line = "V12" + std::string(300, 'b') + "W34";
    const Snippet first = snippet(line, 1, 4, 60), last = snippet(line, 304, 307, 60);
    EXPECT_EQ(first.text.substr(first.indent.size(), first.carets), "V12");
    EXPECT_EQ(first.text.size(), 60u);
    EXPECT_EQ(last.text.substr(last.indent.size(), last.carets), "W34");
    EXPECT_EQ(last.text.size(), 60u);
}

TEST(SnippetTest, AHugeLineCostsNoMoreThanItsNeighbourhood) {
    const std::string line(100'000'000, 'x');
    const Snippet s = snippet(line, 50'000'000, 90'000'000, 60);
    EXPECT_EQ(s.text.size(), 60u);
    EXPECT_LE(s.indent.size() + s.carets, 60u);
}

}  // namespace
}  // namespace fagorc::report
