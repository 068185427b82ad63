// Characters that no block can hold are named, and what they were mistaken for is said.
#include "ir/program/findings.hpp"

#include <gtest/gtest.h>

#include "frontend/structure/program_text.hpp"
#include "ir/diag/catalogue.hpp"
#include "ir/diag/collection.hpp"
#include "tests/unit/frontend/text_side.hpp"

namespace fagorc::frontend {
namespace {

/// "line:column-end: message" of the only finding of a block.
std::string finding(const std::string& block) {
    PlainMaker maker;
    ShapeCache shapes(maker, true);
    diag::Collection found;
    const Scanner scanner(lathe());
    ProgramText program({lathe(), scanner, shapes, found, true}, {}, "part", text_of(block));
    program::report_findings(program, *program.read(program.start()), found);
    if (found.list().size() != 1) return std::to_string(found.list().size()) + " findings";
    const diag::Diagnostic& d = found.list()[0];
    return std::to_string(d.place.column) + "-" + std::to_string(d.place.end_column) + ": " +
           diag::message(d, Language::english);
}

TEST(Findings, LookAlikesAreNamedWithTheCharacterTheyLookLike) {
    const auto names = [](const std::string& block, const char* where, const char* name, const char* like) {
        const std::string told = finding(block);
        EXPECT_TRUE(told.starts_with(where)) << told;
        EXPECT_NE(told.find(name), std::string::npos) << told;
        EXPECT_NE(told.find(like), std::string::npos) << told;
    };
    names("G1\xC2\xA0X1", "3-5: ", "no-break space", "a blank");
    names("G1\xA0X1", "3-4: ", "no-break space", "a blank");
    names(
        "X\xE2\x88\x92"
        "5",
        "2-5: ", "typographic minus", "-");
    names(
        "X\xE2\x80\x93"
        "5",
        "2-5: ", "en dash", "-");
    names("X\xEF\xBC\x93", "2-5: ", "fullwidth digit", "3");
    names(
        "\xEF\xBC\xB8"
        "1",
        "1-4: ", "fullwidth letter", "X");
    names(
        "\xD0\xA5"
        "1",
        "1-3: ", "Cyrillic Kha", "X");
    names(
        "(MSG \xE2\x80\x9C"
        "a)",
        "6-9: ", "quotation mark", "\"");
}

TEST(Findings, OtherCharactersAreShownAsTheyAre) {
    EXPECT_NE(finding("X1 [").find("'['"), std::string::npos) << finding("X1 [");
    EXPECT_NE(finding("X1 \xE9").find("E9"), std::string::npos);
    EXPECT_NE(finding("X1 \xE2\x82\xAC").find("E2 82 AC"), std::string::npos);
}

TEST(Findings, AnOpenTextIsNamed) {
    EXPECT_EQ(finding("(MSG \"abc)").substr(0, 6), "6-11: ");
    EXPECT_EQ(finding("(MSG \"abc)").find("character"), std::string::npos) << finding("(MSG \"abc)");
}

}  // namespace
}  // namespace fagorc::frontend
