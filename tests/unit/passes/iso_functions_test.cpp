// Functions that act by themselves, and what survives the end of a program (8055 T 3.3 to 4.5, 5.1, 7.1 to 7.4).
#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/passes/iso_rig.hpp"

namespace fagorc::passes::testing {
namespace {

using operation::Barrier;
using operation::Dwell;
using operation::Event;
using operation::Line;

std::string alarm_of(std::string_view blocks) {
    return IsoRig().run(blocks).alarm();
}

machine::Machine with_origins() {
    machine::Machine m = built_in_lathe();
    m.origins[1][Axis::Z] = 330;  // the table of 8055 T 4.4.2
    m.origins[2][Axis::Z] = 240;
    m.origins[5][Axis::Z] = -90;
    m.origins[6][Axis::Z] = -180;
    m.origins[6][Axis::X] = 5;
    return m;
}

TEST(IsoFunctions, ZeroOffsetsMoveNothing) {
    IsoRig b(with_origins());
    b.run("G90 G00 X20 Z400\nG54");
    EXPECT_EQ(b.variable("PPOS", Axis::Z), 70);
    b.run("X20");  // Z stays where it is on the machine
    EXPECT_EQ(b.last<Line>().end, (Point{70, 10}));
    EXPECT_EQ(b.frame(b.last_move()).offset[Axis::Z], 330);
    b.run("G58\nZ0");
    EXPECT_EQ(b.frame(b.last_move()).offset[Axis::Z], 240);
    b.run("G55\nG91 Z5");  // from part 0 + 240 to part 0 again
    EXPECT_EQ(b.last<Line>().end.u, 5);
    EXPECT_EQ(b.variable("EXTORG"), 2);
    b.run("G159 N6");
    EXPECT_EQ(b.variable("EXTORG"), 6);
    EXPECT_EQ(b.variable("ORG", Axis::X), 5) << "zero offsets are radii";
    EXPECT_EQ(b.variable("ADDORG", Axis::Z), 0);
    EXPECT_EQ(alarm_of("G159 N21"), "operand_out_of_range");
}

TEST(IsoFunctions, OffsetByValuesTakesXAsAWord) {
    IsoRig b(with_origins());
    b.run("G54\nG158 X20 Z-90\nG00 X0 Z0");
    EXPECT_EQ(b.frame(b.last_move()).offset[Axis::Z], 240);
    EXPECT_EQ(b.frame(b.last_move()).offset[Axis::X], 10);
    b.run("G158\nX0");
    EXPECT_EQ(b.frame(b.last_move()).offset[Axis::Z], 330);
    EXPECT_EQ(b.frame(b.last_move()).offset[Axis::X], 0);
}

TEST(IsoFunctions, PresetOfTheManual) {
    // 8055 T 4.4.1: P0 becomes the part zero, then increments.
    IsoRig b;
    b.run("G18 G152 G01 F100\nG90 X0 Z200\nG92 X0 Z0\nG91 X30 Z-30\nZ-30\nX20\nX20 Z-40\nZ-40");
    EXPECT_EQ(b.last<Line>().end, (Point{-140, 70}));
    EXPECT_EQ(b.frame(b.last_move()).offset[Axis::Z], 200);
    EXPECT_EQ(b.variable("EXTORG"), 0);
    b.run("G151\nG92 X50\nG90 Z0");  // as an X word, the other axes stay
    EXPECT_EQ(b.last<Line>().end, (Point{0, 25}));
    EXPECT_EQ(b.frame(b.last_move()).offset[Axis::X], 45);
    EXPECT_EQ(b.frame(b.last_move()).offset[Axis::Z], 200);
    EXPECT_EQ(alarm_of("G92 C400"), "0199");
    EXPECT_EQ(alarm_of("G92 C-1"), "0199");
}

TEST(IsoFunctions, MachineCoordinates) {
    IsoRig b(with_origins());
    b.run("G54\nG90 G00 X10 Z10\nG53 X140 Z100");
    EXPECT_EQ(b.last<Line>().end, (Point{100, 70}));
    EXPECT_TRUE(b.frame(b.last_move()).machine);
    EXPECT_EQ(b.frame(b.last_move()).offset[Axis::Z], 330);
    b.run("X20");  // the part frame again
    EXPECT_EQ(b.last<Line>().end, (Point{-230, 10}));
    EXPECT_FALSE(b.frame(b.last_move()).machine);
    b.run("G70 G53 Z1");  // the unit of INCHES, not of G70
    EXPECT_EQ(b.last<Line>().end.u, 1);
    EXPECT_EQ(b.last<Line>().end.v, 10);
    b.run("G71 G91 G53 Z2");
    EXPECT_EQ(b.last<Line>().end.u, 2);
    EXPECT_EQ(b.warnings().back(), "machine_coordinates_absolute");
    b.run("G53\nG90 Z0");  // alone: no offset any more
    EXPECT_EQ(b.frame(b.last_move()).offset[Axis::Z], 0);
    EXPECT_EQ(b.last<Line>().end, (Point{0, 10}));
}

TEST(IsoFunctions, MachineCoordinatesAreThoseOfTheTurret) {
    auto lathe = built_in_lathe();
    lathe.offsets[7] = {.x = 40, .z = 25, .nose = 0, .tip = 3, .wear_x = -0.2, .wear_z = 0.05};
    IsoRig b(lathe);
    b.run("T7 D7\nG00 X0 Z0\nG53 X140 Z100");
    // The tip stands its lengths before the turret: 70 - 39.9 and 100 - 25.05 (8055 T 8.1).
    EXPECT_NEAR(b.last<Line>().end.v, 30.1, 1e-12);
    EXPECT_NEAR(b.last<Line>().end.u, 74.95, 1e-12);
}

TEST(IsoFunctions, PolarOriginKeepsItsPlaceUnderAnotherOffset) {
    IsoRig b(with_origins());
    b.run("G152 G90 G00 X10 Z400\nG93 I340 J20\nG54");
    EXPECT_EQ(b.variable("PORGF"), 10);
    EXPECT_EQ(b.variable("PORGS"), 20);
    b.run("G151");
    EXPECT_EQ(b.variable("PORGS"), 40);
}

TEST(IsoFunctions, UnitsHoldInTheirOwnBlock) {
    IsoRig b;
    b.run("G90 G00 X10 Z10\nG152 X10");
    EXPECT_EQ(b.last<Line>().end.v, 10);
    EXPECT_EQ(b.warnings(), std::vector<std::string>{"setting_holds_here"});
    b.run("G152 X12\nG71 X13");  // in force already: nothing to warn of
    EXPECT_EQ(b.warnings().size(), 1u);
}

TEST(IsoFunctions, DwellAndStopOfPreparation) {
    IsoRig b;
    b.run("G04 K50");
    EXPECT_EQ(b.last<Dwell>().seconds, 0.5);
    b.run("G04");
    EXPECT_EQ(b.last<Barrier>().why, Barrier::Why::preparation);
    b.run("G04 K0");
    EXPECT_EQ(b.last<Barrier>().why, Barrier::Why::position);
    b.run("G04");
    b.run("G04 K");
    EXPECT_EQ(b.last<Barrier>().why, Barrier::Why::position);
    EXPECT_EQ(alarm_of("G04 K-1"), "operand_out_of_range");
    EXPECT_EQ(alarm_of("G04 K1.5"), "operand_out_of_range");
}

TEST(IsoFunctions, LookAheadIsStateOfTheMoves) {
    IsoRig b;
    b.run("G51 A50 E0.05 B90\nG90 G01 X10 F100");
    const operation::State& s = b.state(b.last_move());
    EXPECT_EQ(s.modal.corner, program::Corner::look_ahead);
    EXPECT_EQ(s.look_ahead, (operation::LookAhead{50, 0.05, 90}));
    b.run("G51 E0.1\nX11");
    EXPECT_EQ(b.state(b.last_move()).look_ahead, (operation::LookAhead{0, 0.1, 0}));
    b.run("G07\nX12");
    EXPECT_EQ(b.state(b.last_move()).modal.corner, program::Corner::square);
    EXPECT_EQ(b.state(b.last_move()).look_ahead, operation::LookAhead{});
    EXPECT_EQ(alarm_of("G51 A300 E0.05"), "0208");
    EXPECT_EQ(alarm_of("G51 E0.05\nS500 M3\nG95"), "0007");
}

TEST(IsoFunctions, HomeSearch) {
    auto lathe = with_origins();
    lathe.axes[Axis::X].reference = 300;
    lathe.axes[Axis::Z].reference = 500;
    lathe.offsets[7].z = 20;
    IsoRig b(lathe);
    b.run("G54\nT7\nG90 G00 X10 Z0\nG02 X20 Z-5 R5 F100\nG74 Z X");
    const auto& event = b.last<Event>();
    EXPECT_EQ(event.kind, Event::Kind::home);
    EXPECT_TRUE(event.axes.has(Axis::X) && event.axes.has(Axis::Z) && !event.axes.has(Axis::Y));
    EXPECT_EQ(b.last<Barrier>().why, Barrier::Why::preparation);
    EXPECT_EQ(b.variable("PPOS", Axis::Z), 500 - 330 - 20);
    EXPECT_EQ(b.variable("PPOS", Axis::X), 600);
    b.run("Z0");  // G02 is cancelled
    EXPECT_EQ(b.last<Line>().end, (Point{0, 300}));
}

TEST(IsoFunctions, HomeSubroutine) {
    IsoRig b;
    b.run("G74");
    EXPECT_EQ(b.outcome.subroutine, 9990u);
    EXPECT_FALSE(b.runner.subroutine_ended());
    auto lathe = built_in_lathe();
    lathe.home_subroutine.reset();
    EXPECT_EQ(IsoRig(lathe).run("G74").alarm(), "1079");
    lathe.home_subroutine = 9991;  // not defined anywhere
    EXPECT_EQ(IsoRig(lathe).run("G74").alarm(), "1079");
}

TEST(IsoFunctions, PlannedCodesAreRefusedByName) {
    IsoRig b;
    EXPECT_EQ(b.run("G11").alarm(), "not_yet_supported");
    EXPECT_EQ(b.findings.list().back().arguments[0].plain, "G11");
    EXPECT_EQ(alarm_of("G01 G41 X10 F100"), "not_yet_supported");
    EXPECT_EQ(alarm_of("G72 S2"), "not_yet_supported");
    EXPECT_EQ(alarm_of("G40"), "");
}

TEST(IsoFunctions, ResetKeepsOffsetsAndTool) {
    IsoRig b(with_origins());
    b.run("G54\nT3 D4\nG17 G91 G70 G152 G95 G96 G07 F0.1 S100 M3\nG92 S2000\nG01");
    b.run("M30");
    EXPECT_TRUE(b.outcome.program_end);
    b.runner.reset();
    const program::Modal& m = b.runner.modal();
    EXPECT_EQ(m, b.session.machine.power_on);
    EXPECT_EQ(b.variable("ORG", Axis::Z), 330);
    EXPECT_EQ(b.variable("TOOL"), 3);
    EXPECT_EQ(b.variable("TOD"), 4);
    EXPECT_EQ(b.variable("PRGSL"), 0);
    EXPECT_EQ(b.variable("PRGFPR"), 0);
    EXPECT_EQ(b.variable("PRGCSS"), 0);
    b.run("Z1");
    EXPECT_EQ(b.state(b.last_move()).turn, operation::SpindleTurn::stopped);
    EXPECT_TRUE(b.last<Line>().rapid);
}

TEST(IsoFunctions, StartOfTheMachineIsTheTip) {
    auto lathe = built_in_lathe();
    lathe.start[Axis::X] = 50;
    lathe.start[Axis::Z] = 200;
    lathe.start_tool = 2;
    lathe.start_offset = 2;
    lathe.offsets[2].x = 40;
    lathe.offsets[2].z = 25;
    IsoRig b(lathe);
    EXPECT_EQ(b.variable("PPOS", Axis::X), 100);
    b.run("G91 G00 Z1");
    EXPECT_EQ(b.last<Line>().end, (Point{201, 50}));
    EXPECT_EQ(b.frame(b.last_move()), operation::Frame{});
    EXPECT_EQ(b.state(b.last_move()).length_x, 40);
    EXPECT_EQ(b.state(b.last_move()).tool, 2);
}

TEST(IsoFunctions, StatesAreInternedOnce) {
    IsoRig b;
    b.run("G01 X1 F100\nG00 X2\nG01 X3\nG00 X4\nG01 X5");
    EXPECT_EQ(b.tables.states.size(), 2u);
    EXPECT_EQ(b.moves()[0].at.state, b.moves()[4].at.state);
    EXPECT_EQ(b.state(b.moves()[1]).modal.motion, program::Motion::rapid);
}

TEST(IsoFunctions, VariablesOfTheProgramState) {
    IsoRig b;
    b.run("G90 G01 X30 Z-4 F120\nG95 F0.2 S500 M3\nM19 S45\nM45 S-200\nT5 D6");
    EXPECT_EQ(b.variable("PPOS", Axis::X), 30);
    EXPECT_EQ(b.variable("PPOS", Axis::Z), -4);
    EXPECT_EQ(b.variable("PRGF"), 120);
    EXPECT_EQ(b.variable("PRGFPR"), 0.2);
    EXPECT_EQ(b.variable("PRGFIN"), 0);
    EXPECT_EQ(b.variable("PRGS"), 500);
    EXPECT_EQ(b.variable("PRGSP"), 45);
    EXPECT_EQ(b.variable("ASPROG"), -200);
    EXPECT_EQ(b.variable("TOOL"), 5);
    EXPECT_EQ(b.variable("TOD"), 6);
    EXPECT_EQ(b.variable("NXTOOL"), 5);
    EXPECT_EQ(b.variable("HTOR"), 0.4);
    EXPECT_EQ(b.variable("DIAM"), 1);
    EXPECT_EQ(b.variable("PLANE"), 0x31);
    EXPECT_EQ(b.variable("PRGN"), 1234);
    EXPECT_EQ(b.variable("GS", {}, 95), 1);
    EXPECT_EQ(b.variable("GS", {}, 94), 0);
    EXPECT_EQ(b.variable("GS", {}, 10), 1);
    EXPECT_EQ(b.variable("GS", {}, 54), 0);
    EXPECT_EQ(b.variable("MS", {}, 19), 1);
    EXPECT_EQ(b.variable("MS", {}, 3), 0);
    EXPECT_EQ(b.variable("MS", {}, 41), 1);
    EXPECT_TRUE(std::isnan(b.variable("KEY")));
    b.run("G70");
    EXPECT_DOUBLE_EQ(b.variable("PPOS", Axis::X), 30 / 25.4);
    EXPECT_DOUBLE_EQ(b.variable("PRGF"), 120 / 25.4);
}

TEST(IsoFunctions, VariablesThatTheProgramWrites) {
    IsoRig b;
    EXPECT_TRUE(b.runner.assign(b.variable_row("DIAM", false), -1, 0));
    b.run("G00 X10");
    EXPECT_EQ(b.last<Line>().end.v, 10);
    b.run("T1");
    EXPECT_TRUE(b.runner.assign(b.variable_row("HTOR", false), -1, 1.5));
    b.run("X11");
    EXPECT_EQ(b.state(b.last_move()).nose, 1.5);
    b.run("T1\nX12");
    EXPECT_EQ(b.state(b.last_move()).nose, 0.4);
    EXPECT_FALSE(b.runner.assign(b.variable_row("KEY", false), -1, 1));
}

TEST(IsoFunctions, StatesOfOtherStatements) {
    IsoRig b;
    b.runner.enable({program::Enable::What::stop, false});
    b.runner.enable({program::Enable::What::single_block, true});
    b.run("G00 X1");
    EXPECT_TRUE(b.state(b.last_move()).stop_disabled);
    EXPECT_TRUE(b.state(b.last_move()).single_block_joined);
    EXPECT_FALSE(b.state(b.last_move()).feed_hold_disabled);
    b.runner.enable({program::Enable::What::stop, true});
    b.run("X2");
    EXPECT_FALSE(b.state(b.last_move()).stop_disabled);
}

}  // namespace
}  // namespace fagorc::passes::testing
