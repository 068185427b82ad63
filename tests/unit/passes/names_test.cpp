// Numbers that name something: a parameter, a label, a subroutine, a count of repetitions. They are whole; what is not
// names nothing (language sheet 1.8: P13.7 is an error).
#include <gtest/gtest.h>

#include <algorithm>

#include "ir/diag/catalogue.hpp"
#include "tests/unit/passes/run_program.hpp"

namespace fagorc::passes {
namespace {

/// Its first finding as the reader sees it, in English.
std::string first_message(std::string_view text) {
    const ProgramRun run = run_program(text);
    return run.findings.empty() ? "" : diag::message(run.findings.front(), Language::english);
}

TEST(Names, AParameterHasAWholeNumber) {
    const std::string whole = "P must be a whole number, it is 1.5";
    EXPECT_EQ(first_message("(P1=5)\nG0 XP1.5\nM30\n"), whole);
    EXPECT_EQ(first_message("(P1=5)\nG0 X-P1.5\nM30\n"), whole);
    EXPECT_EQ(first_message("(P2=P1.5)\nM30\n"), whole);
    EXPECT_EQ(first_message("(P1.5=3)\nM30\n"), whole);
    EXPECT_EQ(first_message("(PCALL 1, P1.5=3)\nM30\n(SUB 1)\n(RET)\n"), whole);
    EXPECT_EQ(first_message("(P1=0)\nGP1.5 X1\nM30\n"), whole);
}

TEST(Names, AParameterBeyond32BitsDoesNotExist) {
    EXPECT_EQ(first_message("G0 XP4294967297\nM30\n"), "there is no parameter P4294967297");  // 2^32 + 1
    EXPECT_EQ(first_message("(P1=P99999999999)\nM30\n"), "there is no parameter P99999999999");
    EXPECT_EQ(first_message("(P4294967297=1)\nM30\n"), "there is no parameter P4294967297");
}

TEST(Names, ALabelIsWhole) {
    EXPECT_EQ(first_message("N1.5 G0 X1\nM30\n"), "N must be a whole number, it is 1.5");
    EXPECT_EQ(first_message("(GOTO N1.0005)\nN1 M30\n"), "1.0005 must be a whole number, it is 1.0005");
}

TEST(Names, ASubroutineIsWhole) {
    EXPECT_EQ(run_program("(CALL 1)\nM30\n(SUB 1.5)\nG0 X1\n(RET)\n").errors(),
              "subroutine_undefined 1057, decimals_not_allowed 0153");
    EXPECT_EQ(first_message("(LSUB 1.5)\n(RET)\n%\nM30\n"), "LSUB must be a whole number, it is 1.5");
}

TEST(Names, ARepetitionCountIsWhole) {
    EXPECT_EQ(first_message("(CALL 5)N2.7\nM30\n(SUB 5)\n(RET)\n"), "N must be a whole number, it is 2.7");
    EXPECT_EQ(first_message("N1 G0 X1\nN2 X2\n(RPT N1,N2) N1.5\nM30\n"), "N must be a whole number, it is 1.5");
    EXPECT_EQ(first_message("(MCALL 5)\nG0 X50 N2.7\nM30\n(SUB 5)\n(RET)\n"), "N must be a whole number, it is 2.7");
}

TEST(Names, TheTextSaysWhatIsWrongWithAComputedNumber) {
    EXPECT_EQ(first_message("(P1=1)\n(GOTO N(P1-5))\nM30\n"), "P1-5 cannot be negative, it is -4");
    EXPECT_EQ(first_message("(P1=1.5)\n(CALL P1)\nM30\n"), "P1 must be a whole number, it is 1.5");
    EXPECT_EQ(first_message("(CALL 99999999999)\nM30\n"), "99999999999 is too large, it is 99999999999");
}

TEST(Names, ACodeBeyondEveryTableIsShownAsWritten) {
    EXPECT_EQ(first_message("M99999\nM30\n"), "M99999 does not exist, M functions go from M0 to M9999");
    EXPECT_TRUE(first_message("G70000\nM30\n").starts_with("G70000 does not exist"));
    const ProgramRun run = run_program("M99999\nM88888\nM30\n");  // one shape
    ASSERT_EQ(run.findings.size(), 2u);
    EXPECT_EQ(run.findings[1].arguments.front().plain, "M88888");
}

TEST(Names, AMissingFeedNamesItsMode) {
    EXPECT_EQ(first_message("S100 M3\nF0.2\nG95\nG1 X50\nM30\n"),
              "no F above zero is programmed under G95, so the move runs at the highest feed of its axes");
}

TEST(Names, DecimalsAreRoundedWithAWarningAtEachPlace) {
    const ProgramRun run = run_program("G0 X1.00001\nX2.00002 Z3\nM30\n");
    EXPECT_EQ(std::count_if(run.findings.begin(), run.findings.end(),
                            [](const auto& d) { return d.id == diag::Id::decimals_rounded; }),
              2);
}

}  // namespace
}  // namespace fagorc::passes
