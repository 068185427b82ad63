// Programs that arrive through a pipe: whole blocks before the end of the input, jumps back, constant memory.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <string>

#include "frontend/structure/program_text.hpp"
#include "ir/diag/collection.hpp"
#include "tests/unit/frontend/text_side.hpp"

namespace fagorc::frontend {
namespace {

/// Both ends of a pipe and the text of its reading end.
class StreamText : public testing::Test {
  protected:
    void SetUp() override {
        int ends[2];
        ASSERT_EQ(::pipe(ends), 0);
        read_end = ends[0];
        write_end = ends[1];
        text = text_of_stream(ends[0], "<stdin>", found);
        ASSERT_TRUE(text);
    }
    void TearDown() override { close(); }
    void send(std::string_view bytes) {
        ASSERT_EQ(::write(write_end, bytes.data(), bytes.size()), static_cast<ssize_t>(bytes.size()));
    }
    void close() {
        if (write_end >= 0) ::close(write_end);
        write_end = -1;
    }
    std::string_view ready() const { return {text->data(), text->ready()}; }

    int read_end = -1, write_end = -1;
    diag::Collection found;
    std::unique_ptr<Text> text;
};

TEST_F(StreamText, ABlockIsReadyAsSoonAsItIsWhole) {
    send("X1\n");
    EXPECT_TRUE(text->reach(0));
    EXPECT_EQ(ready(), "X1\n");
    EXPECT_FALSE(text->complete());
    send("X2\nX");
    EXPECT_TRUE(text->reach(3));
    EXPECT_EQ(ready(), "X1\nX2\n");
    send("3");
    close();
    EXPECT_TRUE(text->reach(6));
    EXPECT_EQ(ready(), "X1\nX2\nX3");
    EXPECT_EQ(text->data()[text->ready()], '\n');
    EXPECT_FALSE(text->reach(8));
    EXPECT_TRUE(text->complete());
    EXPECT_FALSE(text->take_failure());
}

TEST_F(StreamText, ACrWaitsForTheLfThatMayFollow) {
    send("X1\rX2\r");
    EXPECT_TRUE(text->reach(0));
    EXPECT_EQ(ready(), "X1\r");
    send("\nX3\r");
    EXPECT_TRUE(text->reach(3));
    EXPECT_EQ(ready(), "X1\rX2\r\n");
    close();
    EXPECT_EQ(text->all(), "X1\rX2\r\nX3\r");
}

TEST_F(StreamText, TheEndMarksOfTheWireAreTakenAway) {
    send(std::string_view("X1\r\n\x1a\0\0", 7));
    close();
    EXPECT_EQ(text->all(), "X1\r\n");
    EXPECT_FALSE(text->reach(4));
}

TEST_F(StreamText, NothingIsAnEmptyText) {
    close();
    EXPECT_FALSE(text->reach(0));
    EXPECT_EQ(text->all(), "");
    EXPECT_TRUE(found.list().empty());
}

TEST_F(StreamText, BinaryInputIsRefused) {
    send(
        "\x7F"
        "ELF\x02\x01\x01\n");
    EXPECT_FALSE(text->reach(0));
    ASSERT_EQ(found.list().size(), 1u);
    EXPECT_EQ(found.list()[0].id, diag::Id::binary_file);
}

/// A line of `size` bytes into `end` of a pipe, from a process of its own that does not hold the other end open.
void send_line(int end, int other_end, std::size_t size, std::string_view tail) {
    if (::fork() != 0) return;
    ::close(other_end);
    const std::string part(std::size_t{1} << 20, 'X');
    for (std::size_t sent = 0; sent < size; sent += part.size())
        if (::write(end, part.data(), part.size()) < 0) ::_exit(1);
    ::_exit(::write(end, tail.data(), tail.size()) < 0);
}

TEST_F(StreamText, OfABlockBeyondAllMeasureOnlyTheBeginningIsKept) {
    send_line(write_end, read_end, 50'000'000, "\r\nX2\n");
    close();
    const std::string_view all = text->all();
    EXPECT_LT(all.size(), 2'000'000u);
    EXPECT_GT(all.find('\r'), 65536u);  // still too long for a block
    EXPECT_EQ(all.substr(all.find('\r')), "\r\nX2\n");
    EXPECT_FALSE(text->take_failure());
    ::wait(nullptr);
}

TEST_F(StreamText, AnInputWithoutLineEndsIsGivenUp) {
    send_line(write_end, read_end, 400'000'000, "\n");
    close();
    EXPECT_FALSE(text->reach(0));
    const auto failure = text->take_failure();
    ASSERT_TRUE(failure);
    EXPECT_EQ(failure->id, diag::Id::no_line_end);
    EXPECT_FALSE(text->take_failure());
    text.reset();  // closes the pipe: the writer ends
    ::wait(nullptr);
}

// A folder opens, and cannot be read (EISDIR).
TEST(StreamProgram, AnInputThatBreaksOffIsToldOnce) {
    diag::Collection found;
    PlainMaker maker;
    ShapeCache shapes(maker, true);
    const Scanner scanner(lathe());
    const int folder = ::open("/", O_RDONLY | O_DIRECTORY);
    ProgramText program({lathe(), scanner, shapes, found, true}, {}, "<stdin>",
                        text_of_stream(folder, "<stdin>", found));
    EXPECT_FALSE(program.read(program.start()));
    EXPECT_FALSE(program.label(1));
    program.check_unread(found);
    ASSERT_EQ(found.list().size(), 1u);
    EXPECT_EQ(found.list()[0].id, diag::Id::cannot_read);
    EXPECT_EQ(found.list()[0].arguments.at(0).plain, "<stdin>");
}

TEST(StreamProgram, JumpsBackAndForthWhileItArrives) {
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    diag::Collection found;
    PlainMaker maker;
    ShapeCache shapes(maker, true);
    const Scanner scanner(lathe());
    ProgramText program({lathe(), scanner, shapes, found, true}, {}, "<stdin>",
                        text_of_stream(ends[0], "<stdin>", found));
    const auto send = [&](std::string_view s) { ASSERT_GT(::write(ends[1], s.data(), s.size()), 0); };

    send("N10 X1\nX2\nN20 X3\n");
    program::Cursor at = program.start();
    for (const char* expected : {"N10 X1", "X2", "N20 X3"}) {
        const program::Block* block = program.read(at);
        ASSERT_TRUE(block);
        EXPECT_EQ(block->text, expected);
        at = block->next;
    }
    ASSERT_TRUE(program.label(10));
    EXPECT_EQ(program.read(*program.label(10))->text, "N10 X1");
    // Looking for a label ahead reads on and leaves the block that is executed alone.
    const program::Block* block = program.read(*program.label(20));
    send("X4\nN3");
    send("0 X5\nX6");
    ASSERT_TRUE(program.label(30));
    EXPECT_EQ(block->text, "N20 X3");
    EXPECT_EQ(block->slots[1].value, 3);
    EXPECT_EQ(program.label(30)->line, 5u);
    ::close(ends[1]);
    EXPECT_FALSE(program.label(40));
    EXPECT_EQ(program.read({program.label(30)->offset + 7, 6})->text, "X6");
}

/// Peak resident memory of this process, bytes; 0 where the system does not tell.
std::size_t peak_memory() {
    std::ifstream status("/proc/self/status");
    for (std::string line; std::getline(status, line);)
        if (line.starts_with("VmHWM:")) return std::stoul(line.substr(6)) * 1024;
    return 0;
}

TEST(StreamProgram, MemoryStaysConstantOverTwoHundredMegabytes) {
#if defined(__SANITIZE_ADDRESS__)
    GTEST_SKIP() << "the sanitizer's own memory would be measured";
#endif
    constexpr std::size_t total = 200'000'000;
    int ends[2];
    ASSERT_EQ(::pipe(ends), 0);
    std::string lines;
    while (lines.size() < 100'000) lines += "N10 G1 X12.345 Z-67.89 F200\r\n";
    const pid_t writer = ::fork();
    ASSERT_GE(writer, 0);
    if (writer == 0) {
        ::close(ends[0]);
        for (std::size_t sent = 0; sent < total;) {
            const ssize_t n = ::write(ends[1], lines.data(), lines.size());
            if (n <= 0) ::_exit(1);
            sent += static_cast<std::size_t>(n);
        }
        ::_exit(0);
    }
    ::close(ends[1]);
    std::ofstream("/proc/self/clear_refs") << "5";  // the peak starts anew
    const std::size_t before = peak_memory();

    diag::Collection found;
    PlainMaker maker;
    ShapeCache shapes(maker, true);
    const Scanner scanner(lathe());
    std::uint64_t blocks = 0;
    {
        ProgramText program({lathe(), scanner, shapes, found, true}, {}, "<stdin>",
                            text_of_stream(ends[0], "<stdin>", found));
        program::Cursor at = program.start();
        while (const program::Block* block = program.read(at)) {
            ++blocks;
            at = block->next;
        }
        program.check_unread(found);
    }
    const std::size_t after = peak_memory();
    int status = 1;
    ::waitpid(writer, &status, 0);
    EXPECT_EQ(status, 0);
    EXPECT_GE(blocks, total / 29);
    EXPECT_TRUE(found.list().empty());
    EXPECT_LT(after - before, std::size_t{64} << 20);
}

}  // namespace
}  // namespace fagorc::frontend
