// Statements of the high-level language, each form (8055 T chapter 12).
#include <gtest/gtest.h>

#include "tests/unit/frontend/shapes.hpp"

namespace fagorc {
namespace {

class Statements : public testing::TestWithParam<BlockCase> {};

TEST_P(Statements, Bind) {
    EXPECT_EQ(shape_text(GetParam().block), GetParam().shape) << GetParam().block;
}

INSTANTIATE_TEST_SUITE_P(
    Assignments, Statements,
    testing::Values(BlockCase{"(P1=3)", "assign(P#0 = #1)"}, BlockCase{"(A13.7)", "assign(A = #0)"},
                    BlockCase{"(A-5)", "assign(A = negate(#0))"}, BlockCase{"(M30)", "assign(M = #0)"},
                    BlockCase{"(P=2, Z=P)", "assign(P = #0, Z = P)"},
                    BlockCase{"(P(P2+1)=4)", "assign(P(add(P#0, #1)) = #2)"},
                    BlockCase{"(HTOR=0.4)", "assign(HTOR = #0)"},
                    BlockCase{"(ORGX 55=(ORGX 54+P100))", "assign(ORGX(#0) = add(ORGX(#1), P#2))"},
                    BlockCase{"(TORP1=3, TOX(P2)=1)", "assign(TOR(P#0) = #1, TOX(P#2) = #3)"}));

INSTANTIATE_TEST_SUITE_P(
    Flow, Statements,
    testing::Values(BlockCase{"(GOTO N22)", "goto(#0)"}, BlockCase{"(GOTON(P1+2))", "goto(add(P#0, #1))"},
                    BlockCase{"N30 (RPT N10, N20) N3", "label=#0 repeat(#1, #2) repeat=#3"},
                    BlockCase{"(RPT N(P1), N20, P5)", "repeat(P#0, #1, program #2)"},
                    BlockCase{"(IF P1 EQ 2 GOTO N5)", "if(EQ(P#0, #1), goto(#2))"},
                    BlockCase{"(IF(P8EQ12.8)CALL3ELSE PCALL5,A2,B5)",
                              "if(EQ(P#0, #1), call(#2), else call_with(#3, A = #4, B = #5))"},
                    BlockCase{"(IF (E EQ 10) M10)", "if(EQ(E, #0), assign(M = #1))"},
                    BlockCase{"(IF P1 EQ ORGX P2=3)", "if(EQ(P#0, ORGX), assign(P#1 = #2))"},
                    BlockCase{"(IF A P1=1, P2=2 ELSE P1=3)", "if(A, assign(P#0 = #1, P#2 = #3), else assign(P#4 = #5))"},
                    BlockCase{"(IF KEY EQ $FC06 SYSTEM ELSE GOTO N5)",
                              "if(EQ(KEY, #0), screen(SYSTEM: ), else goto(#1))"}));

INSTANTIATE_TEST_SUITE_P(
    Subroutines, Statements,
    testing::Values(BlockCase{"(SUB 5)", "sub(#0)"}, BlockCase{"(LSUB 7)", "lsub(#0)"}, BlockCase{"(RET)", "ret"},
                    BlockCase{"(CALL 5) N3", "call(#0) repeat=#1"}, BlockCase{"(CALL P1)", "call(P#0)"},
                    BlockCase{"(LL9505)", "call_local(#0)"},
                    BlockCase{"(PCALL (P1+1), A1, P200=0)", "call_with(add(P#0, #1), A = #2, P#3 = #4)"},
                    BlockCase{"(MCALL 5, A=P1)", "call_modal(#0, A = P#1)"}, BlockCase{"(MDOFF)", "end_modal"},
                    BlockCase{"(PROBE 1, B5, N3)", "probe(#0, B = #1, N = #2)"},
                    BlockCase{"(REPOS X, Z)", "reposition(X, Z)"}));

INSTANTIATE_TEST_SUITE_P(
    Programs, Statements,
    testing::Values(BlockCase{"(EXEC P100)", "exec(#0, memory)"}, BlockCase{"(EXEC P100, HD)", "exec(#0, disk)"},
                    BlockCase{"(MEXEC P(P100), DNCE)", "mexec(P#0, ethernet)"},
                    BlockCase{"(OPEN P500)", "open(#0, memory, new)"},
                    BlockCase{"(OPEN P500, DNC2, A, \"txt\")", "open(#0, serial, append, #1)"},
                    BlockCase{"(OPEN P500, D)", "open(#0, memory, replace)"},
                    BlockCase{"(WRITE (IF P1 EQ ?P2 \"a)\") ; b)", "write(#0)"}));

INSTANTIATE_TEST_SUITE_P(
    Messages, Statements,
    testing::Values(BlockCase{"(ERROR 5)", "error(#0)"}, BlockCase{"(ERROR P100, \"oops\")", "error(P#0, #1)"},
                    BlockCase{"(ERREUR \"oops\")", "error(, #0)"}, BlockCase{"(MSG \"x ?P1 (;)\")", "message(#0)"},
                    BlockCase{"(DGWZ -1, 2, P3, 4)", "graphic_zone(negate(#0), #1, P#2, #3)"},
                    BlockCase{"(ESBLK)", "enable(single_block)"}, BlockCase{"(DSBLK)", "disable(single_block)"},
                    BlockCase{"(ESTOP)", "enable(stop)"}, BlockCase{"(DSTOP)", "disable(stop)"},
                    BlockCase{"(EFHOLD)", "enable(feed_hold)"}, BlockCase{"(DFHOLD)", "disable(feed_hold)"}));

INSTANTIATE_TEST_SUITE_P(
    Customisation, Statements,
    testing::Values(BlockCase{"(PAGE 10)", "screen(PAGE: #0)"}, BlockCase{"(SYMBOL 1, P2, 3)", "screen(SYMBOL: #0, P#1, #2)"},
                    BlockCase{"(IB1=INPUT \"X:\", -5.4)", "screen(IB: #0, negate(#2), #1)"},
                    BlockCase{"(IB(P1)=INPUT \"X:\")", "screen(IB: P#0, #1)"},
                    BlockCase{"(ODW 1, 2, 3)", "screen(ODW: #0, #1, #2)"},
                    BlockCase{"(DW1=P1, DWH2=5)", "screen(DW: #0, P#1, #2, #3)"},
                    BlockCase{"(SK1=\"A\", SK2=\"B\")", "screen(SK: #0, #2, #1, #3)"},
                    BlockCase{"(WKEY)", "screen(WKEY: )"}, BlockCase{"(WBUF \"X\", P1)", "screen(WBUF: P#1, #0)"},
                    BlockCase{"(WBUF)", "screen(WBUF: )"}, BlockCase{"(SYSTEM)", "screen(SYSTEM: )"}));

}  // namespace
}  // namespace fagorc
