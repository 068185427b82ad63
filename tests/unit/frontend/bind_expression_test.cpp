// Expressions: precedence, associativity, static types (8055 T 11.4, 11.5).
#include <gtest/gtest.h>

#include "tests/unit/frontend/shapes.hpp"

namespace fagorc {
namespace {

/// What `(P0=TEXT)` assigns, in prefix form.
std::string expression(const std::string& text) {
    const auto shape = shape_of("(P0=" + text + ")");
    const auto& assign = std::get<program::Assign>(std::get<program::Statement>(shape.body).what);
    return program::describe(shape, assign.list.front().value, *frontend::dialect("8055"));
}

struct ExpressionCase {
    const char* text;
    const char* prefix;  ///< slot 0 is the number of P0
};

class Expressions : public testing::TestWithParam<ExpressionCase> {};

TEST_P(Expressions, Bind) {
    EXPECT_EQ(expression(GetParam().text), GetParam().prefix) << GetParam().text;
}

INSTANTIATE_TEST_SUITE_P(
    Precedence, Expressions,
    testing::Values(ExpressionCase{"1+2*3", "add(#1, multiply(#2, #3))"},
                    ExpressionCase{"(1+2)*3", "multiply(add(#1, #2), #3)"},
                    ExpressionCase{"1-2-3", "subtract(subtract(#1, #2), #3)"},
                    ExpressionCase{"1/2*3", "multiply(divide(#1, #2), #3)"},
                    ExpressionCase{"-2 EXP 2", "power(negate(#1), #2)"},
                    ExpressionCase{"2 EXP 3 EXP 2", "power(power(#1, #2), #3)"},
                    ExpressionCase{"7 MOD 4*2", "multiply(modulo(#1, #2), #3)"},
                    ExpressionCase{"2*3 EXP 4", "multiply(#1, power(#2, #3))"},
                    ExpressionCase{"SIN 10+45", "add(SIN(#1), #2)"},
                    ExpressionCase{"P4/P5-P6*P7-P8/P9",
                                   "subtract(subtract(divide(P#1, P#2), multiply(P#3, P#4)), divide(P#5, P#6))"},
                    ExpressionCase{"1+2 GT 3 EQ 1", "EQ(GT(add(#1, #2), #3), #4)"},
                    ExpressionCase{"P1 AND 4 EQ 0", "bit_and(P#1, EQ(#2, #3))"},
                    ExpressionCase{"A OR B AND C", "bit_or(A, bit_and(B, C))"},
                    ExpressionCase{"A XOR B AND C", "bit_and(bit_xor(A, B), C)"}));

INSTANTIATE_TEST_SUITE_P(
    Operands, Expressions,
    testing::Values(ExpressionCase{"PI", "pi"}, ExpressionCase{"$FF", "#1"}, ExpressionCase{"+5", "#1"},
                    ExpressionCase{"--5", "negate(negate(#1))"}, ExpressionCase{"P", "P"},
                    ExpressionCase{"P7", "P#1"}, ExpressionCase{"P(P7)", "P(P#1)"},
                    ExpressionCase{"P(P8+SIN(P8*20))", "P(add(P#1, SIN(multiply(P#2, #3))))"},
                    ExpressionCase{"ARG(-1,-2)", "arg(negate(#1), negate(#2))"},
                    ExpressionCase{"ABS -8", "ABS(negate(#1))"}, ExpressionCase{"-ABS(8)", "negate(ABS(#1))"},
                    ExpressionCase{"ASIN(1)+ASINX", "add(ASIN(#1), ASINX)"}, ExpressionCase{"POSX", "POSX"},
                    ExpressionCase{"ORGX", "ORGX"}, ExpressionCase{"ORGX54", "ORGX(#1)"},
                    ExpressionCase{"ORGX(12+P9)", "ORGX(add(#1, P#2))"}, ExpressionCase{"PLCI 12", "PLCI(#1)"},
                    ExpressionCase{"GPOSX N99 P100", "GPOSX(#1, #2)"},
                    ExpressionCase{"GPOSX N(P1) P(P2)", "GPOSX(P#1, P#2)"}, ExpressionCase{"IB5+IB(P1)", "add(IB(#1), IB(P#2))"}));

// Logical between conditions, binary on 32 bits between anything else (8055 T 11.4).
INSTANTIATE_TEST_SUITE_P(
    Types, Expressions,
    testing::Values(ExpressionCase{"NOT (P1 EQ 3)", "not(EQ(P#1, #2))"}, ExpressionCase{"NOT P1", "complement(P#1)"},
                    ExpressionCase{"P1 EQ 1 AND P2 EQ 2", "and(EQ(P#1, #2), EQ(P#3, #4))"},
                    ExpressionCase{"P1 EQ 1 OR NOT (P2 EQ 2)", "or(EQ(P#1, #2), not(EQ(P#3, #4)))"},
                    ExpressionCase{"P1 EQ 1 XOR P2", "bit_xor(EQ(P#1, #2), P#3)"},
                    ExpressionCase{"NOT (P1 AND P2)", "complement(bit_and(P#1, P#2))"},
                    ExpressionCase{"P1 AND (NOT P2 OR P3)", "bit_and(P#1, bit_or(complement(P#2), P#3))"}));

TEST(Expressions, NeedNoMoreRoomThanTheEvaluatorHas) {
    const auto nested = [](int values) {  // 1+(1+(1+ ... )): all values wait for the last
        std::string text;
        for (int i = 1; i < values; ++i) text += "1+(";
        return "(P0=" + text + "1" + std::string(static_cast<std::size_t>(values) - 1, ')') + ")";
    };
    EXPECT_TRUE(shape_of(nested(program::max_expression_depth)).findings.empty());
    const auto refused = shape_of(nested(program::max_expression_depth + 1));
    ASSERT_EQ(refused.findings.size(), 1u);
    EXPECT_EQ(refused.findings[0].id, diag::Id::expression_too_deep);
    EXPECT_TRUE(refused.broken);
}

TEST(Expressions, MayHaveRedundantParentheses) {
    EXPECT_EQ(expression("((((1))))"), "#1");
}

}  // namespace
}  // namespace fagorc
