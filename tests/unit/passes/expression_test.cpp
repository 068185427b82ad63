// Expressions: the worked results of the manual's table (8055 T 11.4), its priorities, and the alarms of operands.
#include <gtest/gtest.h>

#include "tests/unit/passes/run_program.hpp"

namespace fagorc::passes {
namespace {

/// The value of an expression with up to five decimals, or the error.
std::string value(const std::string& expression) {
    return last_message("(P3=3, P7=7, P12=12, P10=10)\n(P100=" + expression + ")\n(MSG \"?P100\")\nM30\n");
}

TEST(Expression, GivesTheManualsResults) {
    EXPECT_EQ(value("3+4"), "7");
    EXPECT_EQ(value("5-2"), "3");
    EXPECT_EQ(value("-(2*3)"), "-6");
    EXPECT_EQ(value("2*3"), "6");
    EXPECT_EQ(value("9/2"), "4.5");
    EXPECT_EQ(value("7 MOD 4"), "3");
    EXPECT_EQ(value("2 EXP 3"), "8");
    EXPECT_EQ(value("SIN 30"), "0.5");
    EXPECT_EQ(value("COS 30"), "0.86603");
    EXPECT_EQ(value("TAN 30"), "0.57735");
    EXPECT_EQ(value("ASIN 1"), "90");
    EXPECT_EQ(value("ACOS 1"), "0");
    EXPECT_EQ(value("ATAN 1"), "45");
    EXPECT_EQ(value("ARG(-1,-2)"), "243.43495");
    EXPECT_EQ(value("ABS -8"), "8");
    EXPECT_EQ(value("LOG 100"), "2");
    EXPECT_EQ(value("SQRT 16"), "4");
    EXPECT_EQ(value("ROUND 5.83"), "6");
    EXPECT_EQ(value("FIX 5.423"), "5");
    EXPECT_EQ(value("FUP 7"), "7");
    EXPECT_EQ(value("FUP 5.423"), "6");
    EXPECT_EQ(value("BCD 234"), "564");
    EXPECT_EQ(value("BIN $AB"), "171");
    EXPECT_EQ(value("PI"), "3.14159");
}

TEST(Expression, FollowsTheManualsPriorities) {  // 8055 T 11.5.1
    EXPECT_EQ(value("-2 EXP 2"), "4");           // unary minus first
    EXPECT_EQ(value("2 EXP 3 EXP 2"), "64");     // left to right: 8 EXP 2
    EXPECT_EQ(value("7 MOD 4*2"), "6");          // (7 MOD 4)*2
    EXPECT_EQ(value("SIN 30+45"), "45.5");       // (SIN 30)+45
    EXPECT_EQ(value("2+3*4-6/2"), "11");         // 2+12-3
    EXPECT_EQ(value("8-3-2"), "3");
    EXPECT_EQ(value("P12 AND (NOT P10 OR 1)"), "4");  // 12 AND ($FFFFFFF5 OR 1) = 12 AND $FFFFFFF5 = 4
    EXPECT_EQ(value("12 XOR 10 AND 3"), "2");         // (12 XOR 10) AND 3 = 6 AND 3
    EXPECT_EQ(value("8 OR 4 AND 12"), "12");          // 8 OR (4 AND 12)
}

TEST(Expression, TellsConditionsFromBits) {
    EXPECT_EQ(value("NOT (P3 EQ 3)"), "0");     // logical
    EXPECT_EQ(value("NOT P10"), "4294967285");  // 2^32 - 11
    EXPECT_EQ(value("(P3 EQ 3) AND (P7 GT 6)"), "1");
    EXPECT_EQ(value("(P3 NE 3) OR (P7 LE 6)"), "0");
    EXPECT_EQ(value("P3 LT P7"), "1");
    EXPECT_EQ(value("$FFFFFFFE AND $FFFFFFFF"), "4294967294");
}

TEST(Expression, RoundsHalvesAwayFromZeroAndFupUp) {
    EXPECT_EQ(value("ROUND 2.5"), "3");
    EXPECT_EQ(value("ROUND -2.5"), "-3");
    EXPECT_EQ(value("FIX -5.4"), "-5");
    EXPECT_EQ(value("FUP -5.4"), "-5");
    EXPECT_EQ(value("-7 MOD 4"), "-3");  // the sign of the dividend
}

TEST(Expression, RefusesWhatHasNoValue) {
    EXPECT_EQ(value("1/(P3-3)"), "division_by_zero 0091");
    EXPECT_EQ(value("7 MOD (P3-3)"), "division_by_zero 0091");
    EXPECT_EQ(value("TAN 90"), "division_by_zero 0091");
    EXPECT_EQ(value("LOG 0"), "logarithm_of_nothing 0089");
    EXPECT_EQ(value("SQRT -4"), "root_of_negative 0090");
    EXPECT_EQ(value("0 EXP -1"), "power_of_zero 0092");
    EXPECT_EQ(value("-8 EXP 0.5"), "power_of_negative 0093");
    EXPECT_EQ(value("ASIN 2"), "arc_function_range 0094");
    EXPECT_EQ(value("ACOS -1.1"), "arc_function_range 0094");
    EXPECT_EQ(value("ARG(0,0)"), "result_not_a_number");
    EXPECT_EQ(value("10 EXP 400"), "result_not_a_number");
}

TEST(Expression, MarksTheOperandThatHasNoValue) {
    const ProgramRun run = run_program("(P100=5+LOG 0)\nM30\n");
    ASSERT_EQ(run.errors(), "logarithm_of_nothing 0089");
    EXPECT_EQ(run.findings[0].place.line, 1u);
    EXPECT_EQ(run.findings[0].place.column, 9u);  // (P100=5+LOG 0): LOG stands in columns 9 to 11
    EXPECT_EQ(run.findings[0].place.end_column, 12u);
}

TEST(Expression, TakesConstantsOfSixDigitsAndFiveDecimals) {
    EXPECT_EQ(value("123456.12345"), "123456.12345");
    EXPECT_EQ(value("1234567"), "number_too_long 0147");
    EXPECT_EQ(value("0.123456"), "number_too_long 0147");
    EXPECT_EQ(value("$FFFFFFFE"), "4294967294");
}

TEST(Indirect, RoundsTheNumberOfTheParameter) {
    EXPECT_EQ(last_message("(P8=9, P9=3)\n(P100=P(P8+SIN(P8*20)))\n(MSG \"?P100\")\nM30\n"), "3");  // SIN 180
    EXPECT_EQ(last_message("(P107=100)\n(P(P107+2)=8)\n(MSG \"?P102\")\nM30\n"), "8");
    EXPECT_EQ(value("P(3.4)"), "parameter_does_not_exist 1052");
    EXPECT_EQ(value("P(80)"), "parameter_does_not_exist 1052");
    EXPECT_EQ(value("P80"), "parameter_does_not_exist 1052");
    EXPECT_EQ(value("P2000"), "oem_parameter");
}

TEST(Assignment, ChainsFromLeftToRight) {  // 8055 T 12.1: (P1+P2+P3)*P4/P5
    EXPECT_EQ(last_message("(P1=1, P2=2, P3=3, P4=4, P5=5)\n(P1=P1+P2, P1=P1+P3, P1=P1*P4, P1=P1/P5)\n"
                           "(MSG \"?P1\")\nM30\n"),
              "4.8");
}

TEST(Assignment, LettersAreTheLocalParameters) {
    EXPECT_EQ(last_message("(A13.7, Z=2)\n(M30)\n(MSG \"?P0 ?P25 ?P12\")\nM30\n"), "13.7 2 30");
}

TEST(Variables, ReadAndWriteTheTables) {
    EXPECT_EQ(last_message("(TOR3=0.8)\n(P100=TOR3, P101=TOR4)\n(MSG \"?P100 ?P101\")\nM30\n"), "0.8 0.4");
    EXPECT_EQ(last_message("(ORGX 55=20)\n(P100=ORGX 2, P101=ORGX(54+1))\n(MSG \"?P100 ?P101\")\nM30\n"), "20 20");
    // Lengths are in the unit in force: 25.4 mm is one inch.
    EXPECT_EQ(last_message("(TOX3=25.4)\nG70\n(P100=TOX3)\n(MSG \"?P100\")\nM30\n"), "1");
    EXPECT_EQ(last_message("(TMZT1=5)\n(P100=TMZP5, P101=TMZP1)\n(MSG \"?P100 ?P101\")\nM30\n"), "1 -1");
}

TEST(Variables, RefuseWhatTheControlRefuses) {
    EXPECT_EQ(last_message("(TOOL=5)\nM30\n"), "variable_read_only 0075");
    EXPECT_EQ(last_message("(P100=SETGEX)\nM30\n"), "variable_write_only 0076");
    EXPECT_EQ(last_message("(P100=GGSA)\nM30\n"), "variable_not_accessible 0074");
    EXPECT_EQ(last_message("(P100=ORGX 60)\nM30\n"), "index_out_of_range 1052");
    EXPECT_EQ(last_message("(P100=ORGX 30)\nM30\n"), "index_out_of_range 1052");
    EXPECT_EQ(last_message("(P100=PLCI 600)\nM30\n"), "plc_resource_out_of_range 1051");
    EXPECT_EQ(last_message("(ANAO8=2.5)\nM30\n"), "analog_output_busy 0077");
    EXPECT_EQ(last_message("(ANAO1=12)\nM30\n"), "analog_output_out_of_range 0176");
}

TEST(Variables, LookAtTheTextOfAnotherBlock) {  // GPOS: the value written, 100000 for an axis that is not there
    const std::string program = "(P7=12.5)\n(OPEN P100, D)\n(WRITE N99 G0 X20 Z$P7)\n(OPEN P101, D)\n";
    EXPECT_EQ(last_message(program + "(P110=GPOSX N99 P100, P111=GPOSZ N99 P100, P112=GPOSY N99 P100)\n"
                                     "(MSG \"?P110 ?P111 ?P112\")\nM30\n"),
              "20 12.5 100000");
    EXPECT_EQ(last_message("(P110=GPOSX N99 P999)\nM30\n"), "position_target_missing");
}

TEST(LiveValues, AreGivenOrNamed) {
    EXPECT_EQ(last_message("(P100=PLCI12)\n(MSG \"?P100\")\nM30\n", {.live = {{"PLCI12", 1}}}), "1");
    EXPECT_EQ(last_message("(P100=PLCI12)\nM30\n"), "live_value_unknown");
    // What the program wrote itself it reads back.
    EXPECT_EQ(last_message("(PLCM5008=1)\n(P100=PLCM5008)\n(MSG \"?P100\")\nM30\n"), "1");
}

TEST(LiveValues, EndACheckedPathWhereTheyDecide) {
    RunOptions check;
    check.execute.live_may_be_unknown = true;
    const ProgramRun run = run_program("(P100=KEY)\n(P101=P100*2)\nX10\n(IF P101 EQ 4 GOTO N5)\nX20\nN5 M30\n", check);
    EXPECT_EQ(run.errors(), "");
    EXPECT_TRUE(run.result.ended_by_live_value);
    EXPECT_FALSE(run.result.completed);
    EXPECT_TRUE(run.has(diag::Id::path_ends_at_live_value));
    EXPECT_EQ(run.moves().size(), 1u);
}

}  // namespace
}  // namespace fagorc::passes
