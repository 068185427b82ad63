// Where bytes go: whole files or none, and failures that are findings.
#include "backends/output.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

namespace fagorc::backends {
namespace {

namespace fs = std::filesystem;

/// A folder of its own for each test, gone afterwards.
class OutputFile : public ::testing::Test {
  protected:
    OutputFile() {
        std::string name = (fs::temp_directory_path() / "fagorc-output-XXXXXX").string();
        folder = ::mkdtemp(name.data());
    }
    ~OutputFile() override { fs::remove_all(folder); }

    std::string path(const char* name) const { return (folder / name).string(); }
    static std::string read(const fs::path& p) {
        std::ifstream in(p, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    std::size_t files() const { return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), {})); }

    fs::path folder;
};

TEST_F(OutputFile, AppearsWholeAtTheEnd) {
    auto out = open_file(path("a"));
    EXPECT_TRUE(out->write("first "));
    EXPECT_FALSE(fs::exists(path("a")));
    EXPECT_TRUE(out->write("second"));
    EXPECT_TRUE(out->finish());
    EXPECT_EQ(read(path("a")), "first second");
    EXPECT_EQ(files(), 1u);
}

TEST_F(OutputFile, LeavesTheOldFileWhenItIsNotFinished) {
    std::ofstream(path("a")) << "old";
    {
        auto out = open_file(path("a"));
        out->write("new");
    }
    EXPECT_EQ(read(path("a")), "old");
    EXPECT_EQ(files(), 1u) << "the temporary is gone";
}

TEST_F(OutputFile, HasTheModeThatTheUmaskGives) {
    const mode_t mask = ::umask(027);
    auto out = open_file(path("a"));
    out->finish();
    ::umask(mask);
    struct stat status {};
    ASSERT_EQ(::stat(path("a").c_str(), &status), 0);
    EXPECT_EQ(status.st_mode & 0777, 0640u);
}

TEST_F(OutputFile, KeepsASymbolicLink) {
    std::ofstream(path("real")) << "old";
    fs::create_symlink("real", path("link"));
    auto out = open_file(path("link"));
    out->write("new");
    EXPECT_TRUE(out->finish());
    EXPECT_TRUE(fs::is_symlink(path("link")));
    EXPECT_EQ(read(path("real")), "new");
}

TEST_F(OutputFile, AFolderThatIsMissingIsAFinding) {
    auto out = open_file(path("missing/a"));
    EXPECT_FALSE(out->write("x"));
    EXPECT_FALSE(out->finish());
    ASSERT_TRUE(out->failure());
    EXPECT_EQ(out->failure()->id, diag::Id::cannot_write);
}

TEST_F(OutputFile, AFolderInItsPlaceIsAFinding) {
    fs::create_directory(path("a"));
    auto out = open_file(path("a"));
    out->write("x");
    EXPECT_FALSE(out->finish());
    EXPECT_EQ(out->failure()->id, diag::Id::cannot_write);
    out.reset();
    EXPECT_EQ(files(), 1u);
}

TEST_F(OutputFile, AFullDiskIsAFinding) {
    if (!fs::exists("/dev/full")) GTEST_SKIP() << "no /dev/full";
    auto out = open_file("/dev/full");
    EXPECT_FALSE(out->write("x"));
    ASSERT_TRUE(out->failure());
    EXPECT_EQ(out->failure()->id, diag::Id::disk_full);
    EXPECT_TRUE(fs::is_character_file("/dev/full")) << "a device is never replaced";
}

TEST_F(OutputFile, AReaderThatHasGoneIsAFinding) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    const int saved = ::dup(STDOUT_FILENO);
    std::fflush(stdout);
    ::dup2(ends[1], STDOUT_FILENO);
    ::close(ends[0]);
    ::close(ends[1]);
    auto out = open_standard_output();
    const bool written = out->write("x");
    ::dup2(saved, STDOUT_FILENO);
    ::close(saved);
    EXPECT_FALSE(written);
    ASSERT_TRUE(out->failure());
    EXPECT_EQ(out->failure()->id, diag::Id::pipe_closed);
}

}  // namespace
}  // namespace fagorc::backends
