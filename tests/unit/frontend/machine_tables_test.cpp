// The control's own text tables: the form in which it sends them, written here by hand.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "frontend/controls/controls.hpp"
#include "frontend/machine/machine.hpp"
#include "ir/diag/collection.hpp"

namespace fagorc::frontend {
namespace {

using machine::Machine;

class Tables : public testing::Test {
  protected:
    void SetUp() override {
        const auto* test = testing::UnitTest::GetInstance()->current_test_info();
        folder_ = std::filesystem::temp_directory_path() / (std::string("fagorc_tables_") + test->name());
        std::filesystem::remove_all(folder_);
        std::filesystem::create_directories(folder_);
    }
    void TearDown() override { std::filesystem::remove_all(folder_); }

    void write(const std::string& name, const std::string& text) {
        std::ofstream(folder_ / name, std::ios::binary) << text;
    }
    bool read() {
        return read_control_tables(
            folder_, machine_, [this](std::string, std::string) { return diag::FileId{files_++}; }, found_);
    }
    /// "file:line:column-end message" of each finding.
    std::string said() const {
        std::string out;
        for (const diag::Diagnostic& d : found_.list())
            out += std::to_string(static_cast<std::uint32_t>(d.place.file)) + ":" + std::to_string(d.place.line) + ":" +
                   std::to_string(d.place.column) + "-" + std::to_string(d.place.end_column) + " " +
                   diag::message(d, Language::english) + "\n";
        return out;
    }

    std::filesystem::path folder_;
    std::uint32_t files_ = 0;
    diag::Collection found_;
    Machine machine_ = built_in_lathe(*dialect("8055"));
};

TEST_F(Tables, ReadsLatheTables) {
    write("TO",
          "    D001     X   12.50000     Z-   3.25000     R    0.80000     F 3     I-   0.10000     K    0.02000\r\n"
          "    D002     X    0.00000     Z    0.00000     R    0.00000     F 0     I    0.00000     K    0.00000\r\n");
    write("TLF", "          T0001               D002               F201          \r\n");
    machine_.tools[1].insert_width = 4.5;  // as a machine file says: the tables hold no inserts
    write("TMZ", "               P004                   T0001\r\n               P005                   T    \r\n");
    write("ORG",
          "      G54         X  156.50000         Z-   0.01250                       \r\n"
          "      G59         Z    7.00000         C   90.00000                       \r\n");
    write("GUP", "    P100                  0            \r\n    P101               -1.5           \r\n");
    ASSERT_TRUE(read()) << said();
    EXPECT_EQ(said(), "");
    const machine::Offset& d1 = machine_.offsets.at(1);
    EXPECT_EQ(d1.x, 12.5);
    EXPECT_EQ(d1.z, -3.25);
    EXPECT_EQ(d1.nose, 0.8);
    EXPECT_EQ(d1.tip, 3);
    EXPECT_EQ(d1.wear_x, -0.1);
    EXPECT_EQ(d1.wear_z, 0.02);
    EXPECT_EQ(machine_.offset_count, 2);  // D003 is not in the table
    EXPECT_EQ(machine_.tools.size(), 1u);
    EXPECT_EQ(machine_.tool_count, 0);
    EXPECT_EQ(machine_.tools.at(1).offset, 2);
    EXPECT_EQ(machine_.tools.at(1).insert_width, 4.5);
    EXPECT_EQ(machine_.tools.at(1).family, 201);
    EXPECT_EQ(machine_.tools.at(1).pocket, 4);
    EXPECT_EQ(machine_.origins.at(1)[Axis::X], 156.5);
    EXPECT_EQ(machine_.origins.at(1)[Axis::Z], -0.0125);
    EXPECT_EQ(machine_.origins.at(6)[Axis::C], 90);
    EXPECT_EQ(machine_.origins.at(2)[Axis::X], 0);
    EXPECT_EQ(machine_.parameters.at(101), -1.5);
}

TEST_F(Tables, ReadsTheLengthOfAMill) {
    write("TO", "    D001     R    5.00000     L-  22.30000     I    0.10000     K    0.20000\n");
    ASSERT_TRUE(read()) << said();
    EXPECT_EQ(machine_.offsets.at(1).z, -22.3);
    EXPECT_DOUBLE_EQ(machine_.offsets.at(1).nose, 5.1);  // I is wear of the radius there
    EXPECT_EQ(machine_.offsets.at(1).wear_x, 0);
    EXPECT_EQ(machine_.offsets.at(1).wear_z, 0.2);
}

TEST_F(Tables, AreInTheUnitOfTheControl) {
    machine_.inches_parameter = program::LengthUnit::inch;
    write("ORG", "G54 X 1.0 C 90.0\n");
    ASSERT_TRUE(read()) << said();
    EXPECT_DOUBLE_EQ(machine_.origins.at(1)[Axis::X], 25.4);
    EXPECT_EQ(machine_.origins.at(1)[Axis::C], 90);
}

TEST_F(Tables, MagazineAloneEmptiesOtherPockets) {
    write("TMZ", "P001 T0007\n");
    ASSERT_TRUE(read()) << said();
    EXPECT_EQ(machine_.tools.at(7).pocket, 1);
    EXPECT_FALSE(machine_.tools.at(1).pocket.has_value());
    EXPECT_EQ(machine_.tools.at(1).offset, 1);
    EXPECT_EQ(machine_.tools.size(), 99u);
}

TEST_F(Tables, WrongLinesAreReportedAndNothingIsApplied) {
    write("TO", "D001 X 1.0\nD999 X 1.0\nX 1.0\nD002 F 12\n");
    write("ORG", "G54 X 9.0\nG55 Q 1\nG56 X -\n?\n");
    write("GUP", "P100\n");
    EXPECT_FALSE(read());
    EXPECT_EQ(said(),
              "0:2:1-5 this line of the table TO cannot be read: the number is out of range\n"
              "0:3:1-6 this line of the table TO cannot be read: the row has no number of its own\n"
              "0:4:6-10 this line of the table TO cannot be read: the number is out of range\n"
              "1:2:5-8 this line of the table ORG cannot be read: a letter with its value is expected\n"
              "1:3:5-8 this line of the table ORG cannot be read: a number is expected\n"
              "1:4:1-2 this line of the table ORG cannot be read: a letter with its value is expected\n"
              "2:1:1-5 this line of the table GUP cannot be read: a number is expected\n");
    EXPECT_TRUE(machine_.offsets.empty());
    EXPECT_EQ(machine_.origins.at(1)[Axis::X], 0);
}

TEST_F(Tables, FolderWithoutTablesIsAnError) {
    EXPECT_FALSE(read());
    EXPECT_NE(said().find("it holds no table"), std::string::npos) << said();
}

/// The complete memory of a working control, where the reference folder stands beside the project.
TEST(ControlTables, ReadsARealControl) {
    const std::filesystem::path folder = "../shared/real/ned-8055M-windnc-backup/tables";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << folder << " is not here";
    Machine m = built_in_lathe(*dialect("8055"));
    diag::Collection found;
    ASSERT_TRUE(read_control_tables(
        folder, m, [](std::string, std::string) { return diag::FileId{0}; }, found));
    EXPECT_TRUE(found.list().empty());
    EXPECT_EQ(m.offsets.size(), 6u);
    EXPECT_EQ(m.tools.size(), 6u);
    EXPECT_FALSE(m.tools.at(5).pocket.has_value());  // its pocket is empty
    EXPECT_EQ(m.tools.at(6).pocket, 6);
    EXPECT_EQ(m.origins.at(4)[Axis::Z], -19.90661);
    EXPECT_EQ(m.parameters.size(), 200u);
}

}  // namespace
}  // namespace fagorc::frontend
