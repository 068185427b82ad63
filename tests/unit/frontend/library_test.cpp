// Programs that call each other: the folder of programs, and programs that OPEN and WRITE make (8055 T 12.5, 12.8).
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "frontend/controls/controls.hpp"
#include "frontend/frontend.hpp"
#include "ir/diag/collection.hpp"

namespace fagorc::frontend {
namespace {

using Opened = program::Library::Opened;

class Library : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = testing::TempDir() + "fagorc-library-XXXXXX";
        folder = ::mkdtemp(name.data());
        write("000007.PIT", "%SEVEN,MX,\n(SUB 70)\nX7\n(RET)\n");
        write("000008.pim", "X8\nM30\n");
        write("notes.txt", "(SUB 99)\n(RET)\n");
    }
    void TearDown() override { std::filesystem::remove_all(folder); }
    void write(const char* name, const char* text) { std::ofstream(folder / name) << text; }

    std::filesystem::path folder;
    diag::Collection found;
    Workspace workspace{*dialect("8055"), found};
    program::Library& library = workspace.library();
};

TEST_F(Library, ProgramsOfAFolderHaveTheNumbersOfTheirNames) {
    ASSERT_TRUE(workspace.add_library(folder));
    ASSERT_TRUE(library.program(7));
    EXPECT_EQ(library.program(7)->header().comment, "SEVEN");
    EXPECT_EQ(library.program(7), library.program(7));
    EXPECT_EQ(library.program(8)->text(), "X8\nM30\n");
    EXPECT_FALSE(library.program(9));
    EXPECT_TRUE(found.list().empty());
}

// 8055 T 1.1: PIT is the lathe's ending, PIM the mill's.
TEST_F(Library, TheLathesEndingGoesBeforeTheMills) {
    write("000007.PIM", "X70\nM30\n");
    write("000008.PIT", "X80\nM30\n");
    ASSERT_TRUE(workspace.add_library(folder));
    EXPECT_EQ(library.program(7)->header().comment, "SEVEN");
    EXPECT_EQ(library.program(8)->text(), "X80\nM30\n");
    ASSERT_EQ(found.list().size(), 2u);
    for (const diag::Diagnostic& d : found.list()) EXPECT_EQ(d.id, diag::Id::program_number_twice);
}

TEST_F(Library, AnOpenProgramHasItsNumberForItself) {
    program::Program& open = workspace.add("elsewhere/000007.PIT", "X1\nM30\n");
    ASSERT_TRUE(workspace.add_library(folder));
    EXPECT_EQ(library.program(7), &open);
    EXPECT_FALSE(library.subroutine(70).subroutine);  // of the copy in the folder
    Workspace other{*dialect("8055"), found};
    ASSERT_TRUE(other.add_library(folder));
    program::Program* later = other.open((folder / "000007.PIT").string());
    EXPECT_EQ(other.library().program(7), later);
    EXPECT_TRUE(found.list().empty());
}

TEST_F(Library, AMissingFolderIsReported) {
    EXPECT_FALSE(workspace.add_library(folder / "missing"));
    ASSERT_EQ(found.list().size(), 1u);
    EXPECT_EQ(found.list()[0].id, diag::Id::cannot_read_folder);
}

TEST_F(Library, SubroutinesAreFoundInAnyProgramTheOnesAtHandFirst) {
    ASSERT_TRUE(workspace.add_library(folder));
    program::Program& root = workspace.add("root", "CALL\n(SUB 71)\nX1\n(RET)\n");
    EXPECT_EQ(library.subroutine(71).program, &root);
    EXPECT_EQ(library.subroutine(70).program, library.program(7));
    EXPECT_EQ(library.subroutine(70).subroutine->body.line, 3u);
    EXPECT_FALSE(library.subroutine(99).subroutine);  // notes.txt is no program
}

TEST_F(Library, AProgramIsMadeOpenedAgainAndReplaced) {
    EXPECT_FALSE(library.write("X1"));
    EXPECT_EQ(library.open(100, std::nullopt, "MADE"), Opened::created);
    EXPECT_TRUE(library.write("(SUB 5)"));
    EXPECT_EQ(library.program(100)->text(), "%MADE,MX,\n(SUB 5)\n");
    EXPECT_EQ(library.program(100)->header().comment, "MADE");
    EXPECT_TRUE(library.write("X1"));
    EXPECT_TRUE(library.write("(RET)"));
    EXPECT_EQ(library.program(100)->text(), "%MADE,MX,\n(SUB 5)\nX1\n(RET)\n");
    EXPECT_EQ(library.subroutine(5).program, library.program(100));  // and not what it was before
    library.close();
    EXPECT_FALSE(library.write("X2"));

    EXPECT_EQ(library.open(100, std::nullopt, ""), Opened::exists);
    EXPECT_EQ(library.open(100, true, ""), Opened::appended);
    EXPECT_TRUE(library.write("M30"));
    EXPECT_EQ(library.program(100)->text(), "%MADE,MX,\n(SUB 5)\nX1\n(RET)\nM30\n");
    EXPECT_EQ(library.open(100, false, "NEW"), Opened::replaced);
    EXPECT_EQ(library.program(100)->text(), "%NEW,MX,\n");
    EXPECT_FALSE(library.subroutine(5).subroutine);
}

TEST_F(Library, AProgramOfTheFolderIsReplacedInMemoryOnly) {
    ASSERT_TRUE(workspace.add_library(folder));
    EXPECT_EQ(library.open(8, std::nullopt, ""), Opened::exists);
    EXPECT_EQ(library.open(8, false, ""), Opened::replaced);
    EXPECT_TRUE(library.write("X9"));
    EXPECT_EQ(library.program(8)->text(), "%,MX,\nX9\n");
    EXPECT_EQ(std::filesystem::file_size(folder / "000008.pim"), 7u);
}

TEST_F(Library, FindingsPointIntoTheTextTheyWereMadeFor) {
    const diag::FileId text = workspace.add_text("machine.toml", "a = 1\nb = 2\n");
    EXPECT_EQ(workspace.name(text), "machine.toml");
    EXPECT_EQ(workspace.line_at(text, 6), "b = 2");
    program::Program& part = workspace.add("part", "X1\r\nX2");
    EXPECT_EQ(workspace.line_at(part.file(), 4), "X2");
    EXPECT_EQ(workspace.line_at(part.file(), 100), "");
    EXPECT_EQ(workspace.name(diag::FileId::none), "");
}

}  // namespace
}  // namespace fagorc::frontend
