// The machine file: every section's keys reach the machine, and whatever does not fit is refused with its place.
#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "frontend/controls/controls.hpp"
#include "frontend/machine/key.hpp"
#include "frontend/machine/machine.hpp"
#include "ir/diag/collection.hpp"

namespace fagorc::frontend {
namespace {

using machine::Machine;

constexpr diag::FileId file{7};

Machine lathe() {
    return built_in_lathe(*dialect("8055"));
}

Machine read(std::string_view text) {
    diag::Collection found;
    const auto m = read_machine_file(text, "m.toml", file, lathe(), found);
    for (const diag::Diagnostic& d : found.list()) ADD_FAILURE() << diag::message(d, Language::english);
    return m.value_or(Machine{});
}

/// The findings of a wrong file as "line:column-end message".
std::string refuse(std::string_view text) {
    diag::Collection found;
    EXPECT_FALSE(read_machine_file(text, "m.toml", file, lathe(), found)) << text;
    std::string out;
    for (const diag::Diagnostic& d : found.list()) {
        EXPECT_EQ(d.place.file, file);
        out += std::to_string(d.place.line) + ":" + std::to_string(d.place.column) + "-" +
               std::to_string(d.place.end_column) + " " + diag::message(d, Language::english) + "\n";
    }
    return out;
}

TEST(BuiltInLathe, IsTheMachineOfTheSheets) {
    const Machine m = lathe();
    for (Axis a : all_axes) EXPECT_TRUE(m.axes[a].exists);
    EXPECT_EQ(m.axes[Axis::B].type, machine::AxisType::hirth);
    EXPECT_TRUE(m.axes[Axis::C].rollover);
    EXPECT_FALSE(m.axes[Axis::X].min.has_value());
    EXPECT_EQ(m.tool_count, 99);
    EXPECT_EQ(m.offset_count, 255);
    EXPECT_EQ(m.default_offset.nose, 0.4);
    EXPECT_EQ(m.default_offset.tip, 3);
    EXPECT_FALSE(m.misc.at(30).before);
    EXPECT_TRUE(m.misc.at(3).before);
    EXPECT_EQ(m.misc.size(), 7u);
    EXPECT_EQ(m.origins.size(), 20u);
    EXPECT_EQ(m.home_subroutine, 9990u);
    EXPECT_EQ(m.power_on.feed, program::FeedMode::per_minute);
    EXPECT_EQ(m.power_on.x, program::XWord::diameter);
}

TEST(MachineFile, EmptyFileIsTheBaseItself) {
    const Machine m = read("");
    EXPECT_EQ(m.tool_count, lathe().tool_count);
    EXPECT_EQ(m.source, "m.toml");
}

TEST(MachineFile, ReadsTheShapeOfTheContract) {
    const Machine m = read(R"([machine]
control = "8055"
units = "mm"
x = "diameter"
[modal]
motion = "G01"
plane = "G17"
distance = "G91"
feed = "G95"
corner = "G07"
[start]
X = 50.0
Z = 3
tool = 4
offset = 5
[axes.X]
min = -500.0
max = 500.0
[axes.Z]
rapid = 8000
[spindle]
max_rpm = 4000
[[offset]]
number = 1
X = 10.0
Z = 20.0
R = 0.8
F = 2
I = 0.1
K = -0.2
[[tool]]
number = 1
offset = 9
NOSEW = 4.0
[origins]
G54 = { X = 1.5, Z = 300.0 }
N20 = { Z = -7.0 }
[parameters]
P100 = 1.5
[policy]
compmode = 1
comptype = 10
)");
    EXPECT_EQ(m.power_on.motion, program::Motion::line);
    EXPECT_EQ(m.power_on.plane, plane_g17);
    EXPECT_EQ(m.power_on.plane_code, program::PlaneCode::xy);
    EXPECT_EQ(m.power_on.distance, program::Distance::incremental);
    EXPECT_EQ(m.power_on.feed, program::FeedMode::per_revolution);
    EXPECT_EQ(m.power_on.corner, program::Corner::square);
    EXPECT_EQ(m.start[Axis::X], 25.0);  // a diameter
    EXPECT_EQ(m.start[Axis::Z], 3.0);
    EXPECT_EQ(m.start_tool, 4);
    EXPECT_EQ(m.start_offset, 5);
    EXPECT_TRUE(m.axes[Axis::X].exists && m.axes[Axis::Z].exists);
    EXPECT_FALSE(m.axes[Axis::Y].exists || m.axes[Axis::C].exists);
    EXPECT_EQ(m.axes[Axis::X].min, -500.0);
    EXPECT_EQ(m.axes[Axis::Z].rapid, 8000.0);
    EXPECT_EQ(m.axes[Axis::Z].max_feed, 10000.0);
    EXPECT_EQ(m.spindle_max_rpm, 4000.0);
    const machine::Offset& d1 = m.offsets.at(1);
    EXPECT_EQ(d1.x, 10);
    EXPECT_EQ(d1.z, 20);
    EXPECT_EQ(d1.nose, 0.8);
    EXPECT_EQ(d1.tip, 2);
    EXPECT_EQ(d1.wear_x, 0.1);
    EXPECT_EQ(d1.wear_z, -0.2);
    EXPECT_EQ(m.tools.at(1).offset, 9);
    EXPECT_EQ(m.tools.at(1).insert_width, 4.0);
    EXPECT_EQ(m.origins.at(1)[Axis::X], 1.5);
    EXPECT_EQ(m.origins.at(20)[Axis::Z], -7.0);
    EXPECT_EQ(m.parameters.at(100), 1.5);
    EXPECT_EQ(m.policy.compmode, 1);
    EXPECT_EQ(m.policy.comptype, 10);
}

TEST(MachineFile, TakesTheParametersOfTheControlByTheirNames) {
    const Machine m = read(R"([machine]
CIRINERR = 0.02
DFORMAT = 0
IMOVE = 1
IPLANE = "G17"
ISYSTEM = 1
IFEED = 1
ICORNER = 0
PORGMOVE = 1
PLACOMP = 0
COMPMODE = 2
COMPTYPE = 1
FEEDTYPE = true
PERCAX = "YES"
NTOFFSET = 20
TOFFM06 = true
TOOLSUB = 9901
REFPSUB = 0
INT3SUB = 47
AUTOGEAR = true
MAXGEAR2 = 2000
M19TYPE = 0
G00FEED = 6000
MAXFEED = 4000
ADIMPG = 1024
MPG12 = 3
second_spindle = false
live_tool = false
inclined_axis = false
[[m]]
number = 42
subroutine = 9942
before = false
stops = true
m_after_subroutine = false
waits_aux_end = false
)");
    EXPECT_EQ(m.arc_tolerance, 0.02);
    EXPECT_EQ(m.power_on.x, program::XWord::radius);
    EXPECT_EQ(m.power_on.motion, program::Motion::line);
    EXPECT_EQ(m.power_on.plane, plane_g17);
    EXPECT_EQ(m.power_on.distance, program::Distance::incremental);
    EXPECT_EQ(m.power_on.feed, program::FeedMode::per_revolution);
    EXPECT_EQ(m.power_on.corner, program::Corner::square);  // ICORNER 0 is G07
    EXPECT_TRUE(m.polar_origin_follows_arcs);
    EXPECT_FALSE(m.compensation_in_all_planes);
    EXPECT_EQ(m.policy.compmode, 2);
    EXPECT_EQ(m.policy.comptype, 1);
    EXPECT_TRUE(m.feed_zero_is_error && m.c_axis_kept_after_end && m.tool_needs_m06 && m.automatic_gears);
    EXPECT_EQ(m.offset_count, 20);
    EXPECT_EQ(m.tool_subroutine, 9901u);
    EXPECT_FALSE(m.home_subroutine.has_value());
    EXPECT_EQ(m.interrupt_subroutines[2], 47u);
    EXPECT_EQ(m.gear_rpm[1], 2000);
    EXPECT_EQ(m.m19_type, 0);
    EXPECT_EQ(m.axes[Axis::W].rapid, 6000);
    EXPECT_EQ(m.axes[Axis::X].max_feed, 4000);
    EXPECT_EQ(m.other_parameters.at("ADIMPG"), 1024);
    EXPECT_EQ(m.other_parameters.at("MPG12"), 3);
    EXPECT_FALSE(m.second_spindle || m.live_tool || m.inclined_axis);
    const machine::Misc& m42 = m.misc.at(42);
    EXPECT_EQ(m42.subroutine, 9942u);
    EXPECT_TRUE(m42.stops);
    EXPECT_FALSE(m42.before || m42.m_after_subroutine || m42.waits_aux_end);
}

TEST(MachineFile, OrderOfTheFileDoesNotMatter) {
    // X of [start] is halved only where X is a diameter, inches count wherever `units` stands.
    const Machine m =
        read("[start]\nX = 2.0\n[[offset]]\nnumber = 1\nX = 1.0\n[machine]\nx = \"radius\"\nunits = \"inch\"\n");
    EXPECT_DOUBLE_EQ(m.start[Axis::X], 50.8);
    EXPECT_DOUBLE_EQ(m.offsets.at(1).x, 25.4);
    EXPECT_EQ(m.power_on.unit, program::LengthUnit::inch);
    EXPECT_EQ(m.inches_parameter, program::LengthUnit::inch);
}

TEST(MachineFile, InchesAreForLengthsOnly) {
    const Machine m = read(R"([machine]
INCHES = 1
[axes.X]
max = 10
max_feed = 100
[axes.C]
max = 360
[spindle]
max_rpm = 100
[[tool]]
number = 1
NOSEA = 55
NOSEW = 0.125
[origins]
G54 = { X = 1.0, C = 90.0 }
[parameters]
P100 = 1.0
)");
    EXPECT_DOUBLE_EQ(*m.axes[Axis::X].max, 254);
    EXPECT_DOUBLE_EQ(m.axes[Axis::X].max_feed, 2540);
    EXPECT_DOUBLE_EQ(*m.axes[Axis::C].max, 360);
    EXPECT_EQ(m.spindle_max_rpm, 100);
    EXPECT_EQ(m.tools.at(1).insert_angle, 55);
    EXPECT_DOUBLE_EQ(m.tools.at(1).insert_width, 3.175);
    EXPECT_DOUBLE_EQ(m.origins.at(1)[Axis::X], 25.4);
    EXPECT_DOUBLE_EQ(m.origins.at(1)[Axis::C], 90);
    EXPECT_EQ(m.parameters.at(100), 1.0);
    EXPECT_EQ(m.default_offset.nose, 0.4);  // the built-in values stay millimetres
}

TEST(MachineFile, PoliciesMayBeWrittenWithDashes) {
    const Machine m = read("[policy]\nwear-x = \"radius\"\nthread-lead = \"major_axis\"\ns_over_limit = \"clamp\"\n");
    EXPECT_EQ(m.policy.wear_x, machine::Policies::WearX::radius);
    EXPECT_EQ(m.policy.thread_lead, machine::Policies::ThreadLead::major_axis);
    EXPECT_EQ(m.policy.s_over_limit, machine::Policies::OverLimit::clamp);
}

TEST(MachineFile, ReportsEveryFaultWithItsPlace) {
    EXPECT_EQ(refuse("[machine]\nCIRINER = 0.1\n[axs.X]\n"),
              "2:1-8 CIRINER is not a key of a machine file, did you mean CIRINERR\n"
              "3:2-5 axs is not a key of a machine file, did you mean axes\n");
    EXPECT_EQ(refuse("[[offset]]\nnumber = 1\nF = 12\nR = \"big\"\n[[offset]]\nnumber = 1\n[[tool]]\noffset = 1\n"),
              "3:5-7 F must be 0 .. 9, it is 12\n"
              "4:5-10 R takes a number\n"
              "6:10-11 offset 1 is given twice\n"
              "7:1-9 tool needs the key number\n");
    EXPECT_EQ(refuse("[machine]\nunits = \"cm\"\nlive_tool = 2\nCIRINERR = 0\nNTOFFSET = 1.5\nG00FEED = inf\n"),
              "2:9-13 units takes mm, inch\n"
              "3:13-14 live_tool takes true or false\n"
              "4:12-13 CIRINERR must be > 0, it is 0\n"
              "5:12-15 NTOFFSET takes a whole number\n"
              "6:11-14 G00FEED takes a number\n");
    EXPECT_EQ(refuse("[axes]\nX = 1\nQ = {}\n[origins]\nG53 = {}\nG55 = { I = 1 }\n[parameters]\nP99999 = 1\n"),
              "2:5-6 axes.X takes a table\n"
              "3:1-2 Q is not a key of a machine file, did you mean X\n"
              "5:1-4 G53 is not a key of a machine file, did you mean G54\n"
              "6:9-10 I is not a key of a machine file\n"
              "8:1-7 P99999 is not a key of a machine file\n");
    EXPECT_EQ(refuse("[axes.X]\nmin = 10\nmax = -10\n"), "1:7-8 max must be >= 10, it is -10\n");
    EXPECT_EQ(refuse("tool = 3\n"), "1:8-9 tool takes rows in double brackets\n");
}

TEST(MachineFile, ReportsWhatIsNotToml) {
    const std::string said = refuse("[machine]\n# \xC3\xA9\nunits = = 1\n");
    EXPECT_EQ(said.substr(0, 2), "3:") << said;
    EXPECT_NE(said.find("not valid TOML"), std::string::npos) << said;
    EXPECT_NE(refuse("x = \"\xFF\"\n").find("not valid TOML"), std::string::npos);
    EXPECT_NE(refuse(std::string(100000, '[')).find("not valid TOML"), std::string::npos);
}

TEST(MachineFile, ColumnsCountBytes) {
    // The key begins after a quoted key with a letter of two bytes: column 21 in characters, 22 in bytes.
    EXPECT_EQ(refuse("origins = { \"\xC3\xA9\" = {}, G54 = 3 }\n"),
              "1:13-17 \xC3\xA9 is not a key of a machine file\n"
              "1:30-31 G54 takes a table\n");
}

TEST(MachineFile, PageNamesEveryKey) {
    std::ifstream in("docs/machine-file.md");
    ASSERT_TRUE(in) << "run from the project's root";
    std::ostringstream text;
    text << in.rdbuf();
    const std::string page = text.str();
    for (const auto keys : {machine_file::machine_keys(), machine_file::modal_keys(), machine_file::axis_keys(),
                            machine_file::spindle_keys(), machine_file::start_keys(), machine_file::offset_keys(),
                            machine_file::tool_keys(), machine_file::misc_keys(), machine_file::policy_keys()})
        for (const machine_file::Key& k : keys)
            EXPECT_NE(page.find("`" + std::string(k.name) + "`"), std::string::npos) << k.name;
    for (const std::string_view name : machine_file::other_parameters())
        EXPECT_NE(page.find("`" + std::string(name) + "`"), std::string::npos) << name;
}

}  // namespace
}  // namespace fagorc::frontend
