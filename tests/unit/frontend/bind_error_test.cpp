// What is wrong with a block: the finding, the tokens that it marks, the control's number.
#include <gtest/gtest.h>

#include "ir/diag/catalogue.hpp"
#include "tests/unit/frontend/shapes.hpp"

namespace fagorc {
namespace {

using diag::Id;

struct ErrorCase {
    const char* block;
    Id id;
    int first, end;     ///< tokens marked: [first, end)
    const char* alarm;  ///< as the 8055 shows it; empty where the manuals give none
};

class BlockErrors : public testing::TestWithParam<ErrorCase> {};

TEST_P(BlockErrors, AreNamedAndMarked) {
    const auto shape = shape_of(GetParam().block);
    ASSERT_EQ(shape.findings.size(), 1u) << shape_text(GetParam().block);
    const program::Finding& f = shape.findings[0];
    EXPECT_EQ(diag::row(f.id).name, diag::row(GetParam().id).name) << GetParam().block;
    EXPECT_EQ(f.token, GetParam().first) << GetParam().block;
    EXPECT_EQ(f.end_token, GetParam().end) << GetParam().block;
    EXPECT_EQ(diag::alarm({f.id, {}, f.arguments, {}}, "8055"), GetParam().alarm) << GetParam().block;
    EXPECT_TRUE(shape.broken || program::depends_on_text(f.id) || diag::row(f.id).severity == diag::Severity::warning);
}

INSTANTIATE_TEST_SUITE_P(
    Order, BlockErrors,
    testing::Values(ErrorCase{"G01 G90 F100 X10", Id::axis_after_technology, 4, 6, "0002"},
                    ErrorCase{"M3 X10", Id::axis_after_technology, 1, 3, "0002"},
                    ErrorCase{"X10 /1", Id::skip_mark_not_first, 2, 3, "0002"},
                    ErrorCase{"G90 X10 S500 F100", Id::technology_order, 5, 7, "0003"},
                    ErrorCase{"G01 X10 G90", Id::g_after_axis, 3, 4, "0004"},
                    ErrorCase{"G90 X10 F100 G01", Id::g_after_technology, 5, 6, "0009"},
                    ErrorCase{"X10 M8 F100", Id::technology_after_misc, 3, 5, "0012"},
                    ErrorCase{"Z10 X20", Id::axis_order, 2, 4, "0048"}, ErrorCase{"X10 X20", Id::axis_repeated, 2, 4, "0048"},
                    ErrorCase{"X10 F100 F200", Id::repeated_word, 4, 6, "0005"},
                    ErrorCase{"G01 G01 X1", Id::repeated_word, 1, 2, "0005"},
                    ErrorCase{"G02 X10 Z5 I1 I2", Id::repeated_word, 7, 9, "0005"},
                    ErrorCase{"Q30 Q40", Id::two_angles, 2, 4, "0173"},
                    ErrorCase{"X10 N3 Z5", Id::syntax_error, 2, 4, ""}));

INSTANTIATE_TEST_SUITE_P(
    Company, BlockErrors,
    testing::Values(ErrorCase{"G01 G02 X10", Id::incompatible_g, 1, 2, "0007"},
                    ErrorCase{"G01 G74 X", Id::incompatible_g, 1, 2, "0007"},
                    ErrorCase{"G54 X10", Id::must_be_alone, 0, 1, "0011"},
                    ErrorCase{"G04 X10", Id::must_be_alone, 0, 1, "0011"},
                    ErrorCase{"X10 G180 A1", Id::must_be_alone, 2, 3, "0011"},
                    ErrorCase{"X10 T3 M06", Id::tool_change_not_alone, 0, 1, "0011"},
                    ErrorCase{"M3 M8 M10 M11 M12 M13 M14 M15", Id::too_many_misc, 7, 8, "0010"},
                    ErrorCase{"G158 X5 F100", Id::alone_expected, 0, 1, ""}));

INSTANTIATE_TEST_SUITE_P(
    Codes, BlockErrors,
    testing::Values(ErrorCase{"G799", Id::unknown_g, 0, 1, "0008"}, ErrorCase{"G43 X1", Id::code_of_sister_model, 0, 1, "0008"},
                    ErrorCase{"G24 L.5 E.01 K1", Id::code_of_sister_model, 0, 1, "0008"},
                    ErrorCase{"M10000", Id::unknown_misc, 0, 1, ""}, ErrorCase{"M0.5", Id::improper_format, 0, 2, "0006"},
                    ErrorCase{"X10 H5", Id::unknown_word, 2, 4, ""}, ErrorCase{"G01 X10 H5", Id::word_not_taken, 3, 5, "0004"},
                    ErrorCase{"G16 X", Id::plane_axes, 0, 1, "0017"}, ErrorCase{"G22 K1", Id::zone_state_operands, 0, 1, "0018"},
                    ErrorCase{"G36 X80", Id::corner_radius_missing, 0, 1, "0020"},
                    ErrorCase{"G72", Id::scale_operands, 0, 1, "0021"},
                    ErrorCase{"G72 S1 X2", Id::scale_operands, 0, 1, "0021"},
                    ErrorCase{"G93 I10", Id::polar_origin_operands, 0, 1, "0026"},
                    ErrorCase{"G51 A50", Id::look_ahead_operands, 0, 1, "0118"},
                    ErrorCase{"G52 X10 Z10", Id::hard_stop_axis, 0, 1, "0200"}));

INSTANTIATE_TEST_SUITE_P(
    LabelsAndRepetitions, BlockErrors,
    testing::Values(ErrorCase{"N10", Id::empty_block, 0, 2, "0001"}, ErrorCase{"/2", Id::empty_block, 0, 1, "0001"},
                    ErrorCase{"NP1 X10", Id::label_by_parameter, 0, 3, "0014"},
                    ErrorCase{"X10 NP1", Id::label_by_parameter, 2, 5, "0014"},
                    ErrorCase{"X10 N", Id::number_expected, 2, 3, ""},
                    ErrorCase{"/5 X10", Id::improper_format, 0, 1, "0006"}));

INSTANTIATE_TEST_SUITE_P(
    TwoLanguages, BlockErrors,
    testing::Values(ErrorCase{"G00 X10 (P100=1)", Id::mixed_languages, 3, 4, "0087"},
                    ErrorCase{"(P100=1) X10", Id::mixed_languages, 6, 7, "0087"},
                    ErrorCase{"X(P1+2)", Id::mixed_languages, 1, 2, "0087"},
                    ErrorCase{"(G01 X10)", Id::iso_words_in_statement, 3, 4, "0087"},
                    ErrorCase{"(P100=1)(P101=2)", Id::two_statements, 6, 7, ""},
                    ErrorCase{"(P1=2 GOTO N5)", Id::two_statements, 5, 6, ""},
                    ErrorCase{"GOTO N10", Id::opening_parenthesis_missing, 0, 4, "0086"},
                    ErrorCase{"N5 IF P1 EQ 2 GOTO N10", Id::opening_parenthesis_missing, 2, 4, "0086"},
                    ErrorCase{"P100=5", Id::opening_parenthesis_missing, 0, 1, "0086"},
                    ErrorCase{"10 X20", Id::syntax_error, 0, 1, ""}));

INSTANTIATE_TEST_SUITE_P(
    Statements, BlockErrors,
    testing::Values(ErrorCase{"(MSG)", Id::text_expected, 1, 2, "0066"}, ErrorCase{"(ERROR)", Id::text_expected, 1, 2, "0066"},
                    ErrorCase{"(IF (P1 EQ 0))", Id::if_without_action, 1, 2, "0061"},
                    ErrorCase{"(IF (P1 EQ 0) GOTO N1 ELSE)", Id::if_without_action, 11, 12, "0061"},
                    ErrorCase{"(ELSE GOTO N10)", Id::else_without_if, 1, 2, "0061"},
                    ErrorCase{"(IF A IF B GOTO N1)", Id::if_action_invalid, 3, 4, "0060"},
                    ErrorCase{"(IF A SUB 5)", Id::if_action_invalid, 3, 4, "0060"},
                    ErrorCase{"(EXEC 5)", Id::program_number_expected, 2, 3, "0068"},
                    ErrorCase{"(OPEN P500, USB, D)", Id::device_unknown, 5, 8, "0180"},
                    ErrorCase{"(OPEN P500, Q)", Id::append_or_delete_expected, 5, 6, "0181"},
                    ErrorCase{"(LL 5, A1)", Id::parameters_not_taken, 4, 6, ""},
                    ErrorCase{"(CALL 5, A1)", Id::parameters_not_taken, 4, 6, ""},
                    ErrorCase{"(PCALL 5 A2)", Id::comma_expected, 3, 4, "0087"},
                    ErrorCase{"(RPT N10 N20)", Id::comma_expected, 4, 5, "0087"},
                    ErrorCase{"(DGWZ 1, 2)", Id::operands_wrong, 1, 5, ""},
                    ErrorCase{"(GOTO NP1)", Id::opening_parenthesis_missing, 3, 4, "0086"},
                    ErrorCase{"(GOTO N)", Id::number_expected, 3, 4, ""}, ErrorCase{"(N=5)", Id::syntax_error, 1, 2, ""},
                    ErrorCase{"(IB1=5)", Id::input_expected, 4, 5, "0104"},
                    ErrorCase{"(GOTTO N5)", Id::unknown_word_near, 1, 6, ""},
                    ErrorCase{"(TOL1=P211)", Id::word_of_sister_model, 1, 4, ""},
                    ErrorCase{"(DIGIT 1, X1)", Id::word_of_sister_model, 1, 6, ""},
                    ErrorCase{"(ZYGQ 5)", Id::unknown_word, 1, 5, ""}));

INSTANTIATE_TEST_SUITE_P(
    Expressions, BlockErrors,
    testing::Values(ErrorCase{"(P100=3+*4)", Id::expression_malformed, 6, 7, "0081"},
                    ErrorCase{"(P100=)", Id::operation_incomplete, 4, 5, "0083"},
                    ErrorCase{"(P100=5+)", Id::operation_incomplete, 6, 7, "0083"},
                    ErrorCase{"(P100=5*", Id::operation_incomplete, 5, 6, "0083"},
                    ErrorCase{"(P100=P1 P2)", Id::operator_expected, 6, 7, "0080"},
                    ErrorCase{"(P13.7)", Id::equals_expected, 3, 4, "0084"},
                    ErrorCase{"(P100=(1+2)*3", Id::closing_parenthesis_missing, 10, 11, "0085"},
                    ErrorCase{"(P100=ARG 1)", Id::opening_parenthesis_missing, 5, 6, "0086"},
                    ErrorCase{"(P1=TOX)", Id::index_expected, 5, 6, ""},
                    ErrorCase{"(P1=GGSA)", Id::variable_not_accessible, 4, 5, "0074"},
                    ErrorCase{"(TOOL=5)", Id::variable_read_only, 1, 2, "0075"},
                    ErrorCase{"(P1=SETGEX)", Id::variable_write_only, 4, 5, "0076"},
                    ErrorCase{"(P1=SIN P2)", Id::argument_without_parentheses, 4, 5, ""}));

INSTANTIATE_TEST_SUITE_P(Characters, BlockErrors,
                         testing::Values(ErrorCase{"X\xC2\xA0""10", Id::strange_character, 1, 2, ""},
                                         ErrorCase{"X10 [", Id::strange_character, 2, 3, ""},
                                         ErrorCase{"(MSG \"open", Id::strange_character, 2, 3, ""},
                                         ErrorCase{"x10", Id::lower_case_word, 0, 2, ""},
                                         ErrorCase{"(p1=Sin(5))", Id::lower_case_word, 0, 9, ""}));

TEST(BlockErrors, AssignmentsAreCounted) {
    std::string block = "(P100=0";
    for (int i = 1; i < 26; ++i) block += ",P" + std::to_string(100 + i) + "=0";
    EXPECT_TRUE(shape_of(block + ")").findings.empty());
    const auto shape = shape_of(block + ",P126=0)");
    ASSERT_EQ(shape.findings.size(), 1u);
    EXPECT_EQ(shape.findings[0].id, Id::too_many_assignments);
    EXPECT_EQ(shape.findings[0].limit, 26u);
    EXPECT_EQ(shape.findings[0].token, 1 + 26 * 5);  // P # = # , for each of the 26 before it
    EXPECT_FALSE(shape.broken);                      // several to one destination count as one
}

TEST(BlockErrors, AnyTokensMakeATemplate) {
    const control::Dialect& dialect = *frontend::dialect("8055");
    const auto maker = frontend::make_template_maker(dialect);
    std::string deep(5000, '(');
    EXPECT_TRUE(maker->make(deep).broken);
    EXPECT_TRUE(maker->make(std::string(60000, 'X')).broken);
    EXPECT_TRUE(maker->make(std::string("(\x83\xff\xff", 4)).broken);   // a keyword that does not exist
    EXPECT_TRUE(maker->make(std::string("(P#=\x86\xff\xff)", 8)).broken);   // a variable that does not exist
    EXPECT_TRUE(maker->make(std::string("(\x83", 2)).broken);            // the payload is cut off
    for (int a = 0; a < 256; ++a)
        for (const char* around : {"", "(", "X#", "(P#="}) maker->make(around + std::string(1, static_cast<char>(a)));
}

}  // namespace
}  // namespace fagorc
