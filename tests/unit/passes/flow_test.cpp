// Jumps, calls, repetitions, programs that programs write: traces and counts worked out by hand from the manual's rules
// (8055 T chapter 12).
#include <gtest/gtest.h>

#include "tests/unit/passes/run_program.hpp"

namespace fagorc::passes {
namespace {

using Moves = std::vector<std::string>;

TEST(Goto, JumpsToTheFirstBlockWithTheLabel) {
    EXPECT_EQ(run_program("G152\n(GOTO N20)\nX99\nN20 X1\nN20 X2\nM30\n").moves(), (Moves{"1 0", "2 0"}));
    EXPECT_EQ(last_message("(P1=0)\nN1 (P1=P1+1)\n(IF P1 LT 5 GOTO N1)\n(MSG \"?P1\")\nM30\n"), "5");
    EXPECT_EQ(run_program("G152\n(P1=10)\n(GOTO N(P1*2))\nX99\nN20 X1\nM30\n").moves(), (Moves{"1 0"}));
    EXPECT_EQ(last_message("(GOTO N99)\nM30\n"), "label_undefined 1059");
    EXPECT_EQ(last_message("(P1=1)\n(GOTO N(100000*1000*P1))\nM30\n"), "jump_label_out_of_range 0062");
}

TEST(Goto, TakesLabelsLongerThanAConstant) {
    EXPECT_EQ(run_program("(GOTO N12345678)\nX99\nN12345678 M30\n").errors(), "");
}

TEST(If, TakesOneOfTwoActions) {
    EXPECT_EQ(last_message("(P8=12.8)\n(IF P8 EQ 12.8 P1=1, P2=2 ELSE P1=3)\n(MSG \"?P1 ?P2\")\nM30\n"), "1 2");
    EXPECT_EQ(last_message("(IF P8 EQ 12.8 P1=1 ELSE P1=3)\n(MSG \"?P1\")\nM30\n"), "3");
    EXPECT_EQ(last_message("(E=10)\n(IF (E EQ 10) M10)\n(MSG \"?P12\")\nM30\n"), "10");  // P12, no M code
}

TEST(Repeat, RunsASectionAgain) {
    // 8055 T 12.4: once in line and three times from N30.
    const ProgramRun run = run_program(
        "G152 G90\nN10 G00 X10\nZ20\nG01 X5 F100\nG00 Z0\nN20 X0\nN30 (RPT N10, N20) N3\nN40 G01 X20\nM30\n");
    Moves expected;
    for (int i = 0; i < 4; ++i) expected.insert(expected.end(), {"10 0", "10 20", "5 20", "5 0", "0 0"});
    expected.push_back("20 0");
    EXPECT_EQ(run.moves(), expected);
    EXPECT_EQ(run.errors(), "");
}

TEST(Repeat, NumbersItsPassesAndNamesItsCaller) {
    const ProgramRun run = run_program("G152\nN10 X10\nN20 X0\n(RPT N10, N20) N2\nM30\n");
    std::vector<int> passes;
    std::vector<std::uint32_t> callers;
    for (std::size_t i = 0; i < run.operations.size(); ++i) {
        if (!operation::is_motion(run.operations[i].what)) continue;
        passes.push_back(run.operations[i].at.pass);
        callers.push_back(run.chains[i].caller_line);
    }
    EXPECT_EQ(passes, (std::vector<int>{0, 0, 0, 0, 1, 1}));
    EXPECT_EQ(callers, (std::vector<std::uint32_t>{0, 0, 4, 4, 4, 4}));
}

TEST(Repeat, RefusesWhatIsNoSection) {
    EXPECT_EQ(last_message("N10 G0 X10\nN20 X0\n(RPT N20, N10)\nM30\n"), "repeat_labels_reversed");
    EXPECT_EQ(last_message("N10 G0 X10\n(RPT N10, N99)\nM30\n"), "repeat_label_undefined 1060");
    EXPECT_EQ(last_message("N10 G0 X10\nN20 (RPT N10, N20)\nM30\n"), "repeats_itself 1055");
    EXPECT_EQ(run_program("G152\nN10 X10\n(RPT N10, N10) N0\nM30\n").moves(), (Moves{"10 0"}));
}

TEST(Repeat, EndsWhenAJumpLeavesIt) {
    const ProgramRun run = run_program(
        "(P1=0)\nN10 (P1=P1+1)\n(IF P1 EQ 3 GOTO N30)\nN20 X1\n(RPT N10, N20) N9\nN30 (MSG \"?P1\")\nM30\n");
    EXPECT_EQ(run.messages, (Moves{"3"}));
    EXPECT_TRUE(run.has(diag::Id::jump_leaves_level));
    EXPECT_EQ(run.errors(), "");
}

TEST(Call, NestsAndSharesTheCallersLevel) {
    EXPECT_EQ(
        last_message(
            "(P100=0)\n(CALL 1)\n(MSG \"?P100\")\nM30\n(SUB 1)\n(P100=P100*10+1)\n(CALL 2)\n(P100=P100*10+1)\n(RET)\n"
            "(SUB 2)\n(P100=P100*10+2)\n(CALL 3)\n(P100=P100*10+2)\n(RET)\n(SUB 3)\n(P100=P100*10+3)\n(RET)\n"),
        "12321");
    EXPECT_EQ(last_message("(A1)\n(CALL 1) N3\n(MSG \"?P0\")\nM30\n(SUB 1)\n(A=A+1)\n(RET)\n"), "4");  // 1 + 3 runs
}

TEST(Call, WithParametersHasItsOwnLevel) {
    EXPECT_EQ(last_message("(A1, B2)\n(PCALL 1, A=B+5, P200=9)\n(MSG \"?P0 ?P1 ?P100 ?P101 ?P200\")\nM30\n"
                           "(SUB 1)\n(P100=A, P101=B, A=77)\n(RET)\n"),
              "1 2 7 0 9");
    // 8055 T 11.2.14: P0, P2 and P3 given = binary 1101
    EXPECT_EQ(last_message("(PCALL 20, P0=20, P2=3, P3=5)\n(MSG \"?P100\")\nM30\n(SUB 20)\n(P100=CALLP)\n(RET)\n"),
              "13");
}

TEST(Call, KeepsToTheLimits) {
    EXPECT_EQ(last_message("(CALL 77)\nM30\n"), "subroutine_undefined 1057");
    EXPECT_EQ(last_message("(CALL 1)\nM30\n(SUB 1)\n(CALL 1)\n(RET)\n"), "nesting_exceeded 1055");
    EXPECT_EQ(last_message("(PCALL 1, A1)\nM30\n(SUB 1)\n(PCALL 1, A1)\n(RET)\n"), "local_levels_used_up 1054");
    EXPECT_EQ(last_message("X10\n(RET)\nM30\n"), "return_alone 1056");
    EXPECT_EQ(last_message("(CALL 10000)\nM30\n"), "oem_subroutine 1255");
}

TEST(Call, FindsLocalSubroutinesFirst) {
    const std::string text = "%PART,MX,\n(LSUB 5)\n(P100=1)\n(RET)\n%MAIN\n";
    const std::string end = "(MSG \"?P100\")\nM30\n(SUB 5)\n(P100=2)\n(RET)\n(SUB 180)\n(P100=A)\n(RET)\n";
    EXPECT_EQ(last_message(text + "(LL 5)\n" + end), "1");
    EXPECT_EQ(last_message(text + "(CALL 5)\n" + end), "1");
    EXPECT_EQ(last_message(text + "G180 A12.3\n" + end), "12.3");
    EXPECT_EQ(last_message(text + "(LL 180)\n" + end), "subroutine_undefined 1057");
    EXPECT_EQ(last_message("%P,MX,\n(LSUB 180)\nX1\n(RET)\n%MAIN\nG180\nM30\n"), "subroutine_undefined 1057");
}

TEST(ModalCall, RunsAtOnceAndAfterEachMove) {
    // 8055 T 12.5: of X10 N3 the first of the three executions gets the parameters, the others keep the values.
    EXPECT_EQ(last_message("(P100=0)\n(MCALL 10, A1)\n(P101=P100)\nX10 N3\n(MDOFF)\nX20\n(MSG \"?P101 ?P100\")\nM30\n"
                           "(SUB 10)\n(P100=P100+A, A=A+1)\n(RET)\n"),
              "1 7");
    // N0: the move without the subroutine. Moves inside the subroutine do not start it.
    EXPECT_EQ(
        last_message(
            "(P100=0)\nG91\n(MCALL 10)\nX10 N0\nX10\n(MSG \"?P100\")\nM30\n(SUB 10)\n(P100=P100+1)\nZ-1\n(RET)\n"),
        "2");
}

TEST(BlockRepetition, NeedsSomethingModal) {
    EXPECT_EQ(last_message("X10 N3\nM30\n"), "repetition_not_possible 0015");
    EXPECT_EQ(last_message("(P1=1) N3\nM30\n"), "repetition_not_possible 0015");
}

TEST(Subroutines, StandBehindTheMainPart) {
    EXPECT_EQ(last_message("(SUB 12)\nG0 X10\n(RET)\n(CALL 12)\nM30\n"), "subroutine_in_main_part 0065");
    EXPECT_EQ(last_message("G0 X10\n(SUB 12)\nG0 X10\n(RET)\n"), "subroutine_in_main_part 0065");
    const ProgramRun library =
        run_program("%LIB,MX,\n(SUB 1)\nG0 X10\n(REPOS X)\n(RET)\n; a comment\n(SUB 2)\n(CALL 99)\n(RET)\n");
    EXPECT_EQ(library.errors(), "");
    EXPECT_TRUE(library.result.completed);
    EXPECT_TRUE(library.moves().empty());
    EXPECT_EQ(run_program("%LIB,MX,\n(SUB 10000)\n(RET)\n").errors(), "subroutine_number_out_of_range 0063");
}

TEST(Program, EndsAtM30OrWithAWarning) {
    EXPECT_FALSE(run_program("X10\nM30\nX20\n").has(diag::Id::no_program_end));
    const ProgramRun run = run_program("X10\n");
    EXPECT_TRUE(run.has(diag::Id::no_program_end));
    EXPECT_TRUE(run.result.completed);
    EXPECT_EQ(last_message("%NOX,M,\nX10\nM30\n"), "not_executable 0172");
}

TEST(Skip, LeavesOutTheBlocksOfTheMarks) {
    RunOptions marks;
    marks.execute.skip_marks = 2;
    EXPECT_EQ(run_program("G152\n/1 X10\n/2 X20\n/1/2 X30\nX40\nM30\n", marks).moves(), (Moves{"10 0", "40 0"}));
}

TEST(Exec, RunsAProgramThatTheProgramWrote) {
    const ProgramRun run = run_program(
        "G152 G1 F100\n(P100=10, P101=20)\n(OPEN P500, D, \"GENERATED\")\n(WRITE G1 XP100 ZP101 F100)\n"
        "(WRITE M30)\n(OPEN P501)\n(EXEC P500)\nX0 Z0\nM30\n");
    EXPECT_EQ(run.errors(), "");
    EXPECT_EQ(run.moves(), (Moves{"10 20", "0 0"}));  // M30 there comes back
    EXPECT_EQ(last_message("(EXEC P777)\nM30\n"), "program_cannot_run 1064");
    EXPECT_EQ(
        last_message("(OPEN P100, D)\n(WRITE (EXEC P101))\n(WRITE M30)\n(OPEN P101, D)\n(WRITE M30)\n(OPEN P102, D)\n"
                     "(EXEC P100)\nM30\n"),
        "exec_nested 0209");
}

TEST(Open, RefusesAnExistingProgramAndWriteAClosedOne) {
    EXPECT_EQ(last_message("(OPEN P500, D)\n(WRITE G0 X10)\n(OPEN P501, D)\n(OPEN P500)\nM30\n"),
              "program_exists 0070");
    EXPECT_EQ(last_message("(WRITE G0 X10)\nM30\n"), "open_missing 0067");
}

TEST(Error, StopsWithNumberAndText) {
    const ProgramRun run = run_program("(P120=9)\n(ERROR P120, \"no tool\")\nG0 X10\nM30\n");
    EXPECT_EQ(run.errors(), "error_statement");
    ASSERT_EQ(run.findings.size(), 1u);
    EXPECT_EQ(run.findings[0].arguments[0].plain, "9 \"no tool\"");
    EXPECT_TRUE(run.moves().empty());
}

TEST(Texts, HaveAtMost59Characters) {
    EXPECT_EQ(run_program("(MSG \"" + std::string(59, 'A') + "\")\nM30\n").errors(), "");
    EXPECT_EQ(run_program("(MSG \"" + std::string(60, 'A') + "\")\nM30\n").errors(), "text_too_long 0148");
    EXPECT_EQ(run_program("(ERROR 1, \"" + std::string(60, 'A') + "\")\nM30\n").errors(), "text_too_long 0148");
}

TEST(GraphicZone, NeedsItsLimitsInOrder) {
    EXPECT_EQ(last_message("(DGWZ 20, -100, 0, 60)\nM30\n"), "graphic_zone_limits 0234");
    EXPECT_EQ(run_program("(DGWZ -100, 20, 0, 60)\nM30\n").errors(), "");
}

TEST(EndlessLoops, AreFound) {
    EXPECT_EQ(last_message("N10 (GOTO N10)\n"), "endless_loop");
    EXPECT_EQ(last_message("N10 X10\nX0\n(P1=5)\n(GOTO N10)\n"), "endless_loop");  // P1=5 changes nothing
    RunOptions little;
    little.execute.max_blocks = 1000;
    EXPECT_EQ(last_message("N10 (P1=P1+1)\n(GOTO N10)\n", little), "fuel_used_up");
    little.execute = {};
    little.execute.max_blocks_without_motion = 1000;
    EXPECT_EQ(last_message("N10 (P1=P1+1)\n(GOTO N10)\n", little), "no_motion_in_sight");
}

TEST(ParametricG, TakesItsCodeFromAParameter) {
    EXPECT_EQ(run_program("G152\n(P0=1, P1=-12.5)\nGP0 XP1 Z100 F100\nM30\n").moves(), (Moves{"-12.5 100"}));
}

TEST(Customisation, IsCheckedAsAText) {
    EXPECT_EQ(run_program("(ODW 1, 5, 10)\nN5 (DW1=P100)\n(WKEY)\n(IF KEY EQ $FC06 SYSTEM ELSE GOTO N5)\n").errors(),
              "");
    EXPECT_EQ(last_message("G90 G01 X10 F100\n(PAGE 10)\nM30\n"), "screen_statement_in_part 0108");
    EXPECT_EQ(last_message("(PAGE 10)\n(P1=5)\n(SYSTEM)\n"), "local_parameter_not_allowed 0110");
    EXPECT_EQ(last_message("(PAGE 300)\n(SYSTEM)\n"), "page_out_of_range 0103");
    EXPECT_EQ(last_message("(PAGE 255)\n(PAGE 1000)\n(SYSTEM)\n"), "");
    EXPECT_EQ(last_message("(DW5=100)\n(SYSTEM)\n"), "window_not_defined 0171");
    EXPECT_EQ(last_message("(SK 9=\"X\")\n(SYSTEM)\n"), "softkey_out_of_range 0098");
    EXPECT_EQ(last_message("(IB1=INPUT \"X:\", 7.5)\n(SYSTEM)\n"), "entry_format_too_large 0107");
}

}  // namespace
}  // namespace fagorc::passes
