// Texts from memory and from files.
#include "frontend/structure/text.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <thread>

#include "ir/diag/collection.hpp"

namespace fagorc::frontend {
namespace {

using diag::Id;

class TextOfFile : public testing::Test {
  protected:
    void SetUp() override {
        std::string name = testing::TempDir() + "fagorc-text-XXXXXX";
        folder = ::mkdtemp(name.data());
    }
    void TearDown() override { std::filesystem::remove_all(folder); }
    std::unique_ptr<Text> read(const std::string& bytes) {
        std::ofstream(folder / "part.pit", std::ios::binary) << bytes;
        return text_of_file(folder / "part.pit", found);
    }
    Id only() const { return found.list().size() == 1 ? found.list()[0].id : Id{}; }

    std::filesystem::path folder;
    diag::Collection found;
};

TEST(Text, BytesStayAsTheyAre) {
    const std::string bytes("\xEF\xBB\xBFX1\r\n\tX2\rX3\n\nMSG \xE9\x82\0X4", 24);
    EXPECT_EQ(text_of(bytes)->all(), bytes);
    EXPECT_TRUE(text_of(bytes)->complete());
    EXPECT_EQ(text_of("")->all(), "");
    EXPECT_FALSE(text_of("")->reach(0));
}

TEST(Text, ALineEndStandsBehindTheLastByte) {
    for (const char* bytes : {"X1", "X1\r", "X1\n", ""}) {
        const auto text = text_of(bytes);
        EXPECT_EQ(text->data()[text->ready()], '\n');
    }
}

TEST(Text, EndMarksOfTheWireAndOfOldDisksAreNoText) {
    EXPECT_EQ(text_of(std::string("X1\r\n\x1a\x1a\0\0", 8))->all(), "X1\r\n");
    EXPECT_EQ(text_of("X1\x04")->all(), "X1");
    EXPECT_EQ(text_of("\x1a")->all(), "");
    EXPECT_EQ(text_of("X\x1a"
                      "1")
                  ->all(),
              "X\x1a"
              "1");
}

TEST_F(TextOfFile, IsReadWhole) {
    std::string bytes;
    while (bytes.size() < 300'000) bytes += "N10 G1 X" + std::to_string(bytes.size()) + "\r\n";
    const auto text = read(bytes);
    ASSERT_TRUE(text);
    EXPECT_EQ(text->all(), bytes);
    EXPECT_TRUE(found.list().empty());
}

TEST_F(TextOfFile, AMissingFileAndAFolderAreReported) {
    EXPECT_FALSE(text_of_file(folder / "missing.pit", found));
    EXPECT_EQ(only(), Id::cannot_read);
    EXPECT_EQ(found.list()[0].arguments.at(0).plain, folder / "missing.pit");
    found = {};
    EXPECT_FALSE(text_of_file(folder, found));
    EXPECT_EQ(only(), Id::is_a_directory);
}

TEST_F(TextOfFile, Utf16AndBinaryFilesAreRefused) {
    EXPECT_FALSE(read(std::string("\xFF\xFEX\0001\0", 6)));
    EXPECT_EQ(only(), Id::utf16_file);
    found = {};
    EXPECT_FALSE(
        read(std::string("\x7F"
                         "ELF\x02\x01\x01\0\0\x02\x01",
                         11)));
    EXPECT_EQ(only(), Id::binary_file);
    EXPECT_EQ(found.list()[0].arguments.at(0).plain, "5");  // the first such byte, from 1, and its value
    EXPECT_EQ(found.list()[0].arguments.at(1).plain, "2");
}

TEST_F(TextOfFile, OldTextsAreNoBinaryFiles) {
    EXPECT_TRUE(read(std::string("\0\0\0%PART,MX,\r\nX1\r\n\x1a", 19)));  // leader of a tape
    EXPECT_TRUE(read("(MSG \"\xE9\x82\xFF\x9B d\xE9j\xE0\")\r\n"));       // Latin-1, CP850
    EXPECT_TRUE(read(""));
    EXPECT_TRUE(found.list().empty());
}

TEST_F(TextOfFile, ANamedPipeIsReadAsAStream) {
    const std::string path = folder / "pipe";
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    std::thread writer([&] { std::ofstream(path) << "X1\nX2"; });
    const auto text = text_of_file(path, found);
    ASSERT_TRUE(text);
    EXPECT_EQ(text->all(), "X1\nX2");
    writer.join();
}

}  // namespace
}  // namespace fagorc::frontend
