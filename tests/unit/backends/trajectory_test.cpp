// The trajectory file, written and read back by the player, which shares no code with the writer.
#include <gtest/gtest.h>

#include <cstring>

#include "backends/trajectory/writer.hpp"
#include "runtime/player/moves.hpp"
#include "runtime/player/verify.hpp"
#include "tests/support/stream.hpp"

namespace fagorc::test {
namespace {

using player::Kind;
using player::Status;

std::vector<std::byte> written(Stream& s) {
    backends::MemoryOutput output;
    s.play(*backends::make_trajectory_writer(s.job(), output));
    return output.bytes();
}

player::Trajectory opened(const std::vector<std::byte>& bytes, Status expected = Status::ok) {
    player::Trajectory t;
    EXPECT_EQ(t.open(bytes), expected);
    return t;
}

TEST(Trajectory, EveryKindOfMoveComesBack) {
    Stream s = everything();
    const auto bytes = written(s);
    const player::Finding finding = player::verify(bytes);
    ASSERT_EQ(finding.status, Status::ok) << finding.block << ' ' << finding.what;
    const player::Trajectory t = opened(bytes);
    ASSERT_EQ(t.moves(), 9u);
    EXPECT_TRUE(t.completed());

    player::MoveReader reader(t);
    std::vector<player::Move> m;
    while (const player::Move* move = reader.next()) m.push_back(*move);
    ASSERT_EQ(m.size(), 9u);

    // The tip stood at the machine zero; the offset with lengths X2 Z30 puts it two below and thirty to the left.
    EXPECT_EQ(m[0].kind, Kind::rapid);
    EXPECT_EQ(m[0].start[0], -2);
    EXPECT_EQ(m[0].start[2], -30);
    EXPECT_EQ(m[0].end[0], 20);
    EXPECT_EQ(m[0].end[2], 1);
    EXPECT_EQ(m[0].line, 3u);
    EXPECT_EQ(m[1].kind, Kind::line);
    EXPECT_EQ(m[1].feed, 0.25);
    EXPECT_EQ(t.state(m[1].state)->feed_mode, 1);
    EXPECT_EQ(m[2].kind, Kind::clockwise);
    EXPECT_EQ(m[2].centre_u, -20);
    EXPECT_EQ(m[2].centre_v, 20);
    EXPECT_FALSE(m[2].full_turn);
    EXPECT_EQ(m[3].kind, Kind::counter_clockwise);
    EXPECT_TRUE(m[3].full_turn);
    EXPECT_EQ(m[3].pass, 3);
    EXPECT_EQ(m[4].kind, Kind::thread);
    EXPECT_EQ(m[4].lead, 1.5);
    EXPECT_EQ(m[4].start_angle, 90);
    EXPECT_EQ(m[5].kind, Kind::dwell);
    EXPECT_EQ(m[5].seconds, 0.75);
    EXPECT_EQ(m[5].end, m[4].end);
    EXPECT_EQ(m[6].moved, 1 << 8);
    EXPECT_EQ(m[6].end[8], 90);
    EXPECT_EQ(m[7].plane_u, 0);
    EXPECT_EQ(m[7].plane_v, 1);
    EXPECT_EQ(m[7].centre_u, 32);
    EXPECT_EQ(m[7].centre_v, 10);
    EXPECT_EQ(m[7].end[2], -40);
    EXPECT_EQ(t.state(m[7].state)->origin[2], 100);
    EXPECT_EQ(m[8].start[0], 250) << "the home search moved X";
    EXPECT_EQ(m[8].start[1], 10);
    EXPECT_EQ(t.state(m[8].state)->speed, 2000);
    EXPECT_EQ(t.state(m[8].state)->nose, 0.4);
}

TEST(Trajectory, ChainsEventsAndTextsComeBack) {
    Stream s = everything();
    const auto bytes = written(s);
    const player::Trajectory t = opened(bytes);
    ASSERT_EQ(t.chains(), 2u);
    EXPECT_EQ(t.chain(0)->caller, player::none);
    EXPECT_EQ(t.chain(1)->caller, 0u);
    EXPECT_EQ(t.chain(1)->caller_line, 7u);
    EXPECT_EQ(t.program(t.chain(1)->program)->name, "000012.PIT");

    ASSERT_EQ(t.events(), 6u);
    EXPECT_EQ(t.event(0)->kind, 3);  // tool
    EXPECT_EQ(t.event(0)->before, 0u);
    EXPECT_EQ(t.event(2)->before, 4u);
    EXPECT_EQ(t.text(t.event(2)->text), "a \"quoted\", text; \xe9");
    EXPECT_EQ(t.event(3)->kind, 255);
    EXPECT_EQ(t.event(3)->before, 6u);
    EXPECT_EQ(t.event(4)->axes, 1);
    EXPECT_EQ(t.event(4)->value, 250) << "where the home search of X ends";
    EXPECT_EQ(t.event(5)->before, t.moves());
    EXPECT_EQ(t.first_event_before(0), 0u);
    EXPECT_EQ(t.first_event_before(1), 2u);
    EXPECT_EQ(t.first_event_before(9), 5u);
}

TEST(Trajectory, SourceTextsComeBackWholeAndWithoutTheirFolder) {
    Stream s = everything();
    const auto bytes = written(s);
    const player::Trajectory t = opened(bytes);
    ASSERT_EQ(t.programs(), 2u);
    EXPECT_EQ(t.program(0)->name, "part.pit");
    EXPECT_EQ(t.source(0, 0), s.programs.list[0].text);
    std::string text;
    for (std::string_view piece; !(piece = t.source(1, text.size())).empty();) text += piece;
    EXPECT_EQ(text, s.programs.list[1].text);
    EXPECT_EQ(t.program(1)->size, text.size());
}

/// Steps of 0.001 mm along Z; every hundredth block's worth another state, so that many blocks of all kinds are made.
Stream many(int moves) {
    Stream s;
    for (int i = 0; i < moves; ++i) {
        if (i % 1000 == 999) {
            s.now.modal.motion = i % 2000 == 999 ? program::Motion::line : program::Motion::rapid;
            s.next.at.speed = i;
            s.state();
            s.event(operation::Event::Kind::misc, i);
        }
        s.next.moved = {};
        if (i % 5000 == 4999) {
            s.next.moved.add(Axis::C);
            s.next.others[Axis::C] = i;
        }
        s.line(0.001 * i, i % 7);
    }
    return s;
}

TEST(Trajectory, SeekingGivesTheSameMovesAsReadingOn) {
    Stream s = many(20000);
    const auto bytes = written(s);
    ASSERT_EQ(player::verify(bytes).status, Status::ok);
    const player::Trajectory t = opened(bytes);
    std::vector<player::Move> all;
    player::MoveReader reader(t);
    while (const player::Move* m = reader.next()) all.push_back(*m);
    ASSERT_EQ(all.size(), 20000u);
    for (std::uint64_t n = 0; n < all.size(); n += 617) {
        player::MoveReader from(t, n);
        const player::Move* m = from.next();
        ASSERT_NE(m, nullptr);
        EXPECT_EQ(m->number, n);
        EXPECT_EQ(m->start, all[n].start);
        EXPECT_EQ(m->end, all[n].end);
        EXPECT_EQ(m->end[2], 0.001 * static_cast<double>(n));
        EXPECT_EQ(m->line, all[n].line);
        EXPECT_EQ(t.state(m->state)->speed, n < 999 ? 1000 : static_cast<double>((n - 999) / 1000 * 1000 + 999));
    }
    EXPECT_EQ(player::MoveReader(t, 20000).next(), nullptr);
}

TEST(Trajectory, TheSameInputGivesTheSameBytes) {
    Stream a = everything(), b = everything();
    EXPECT_EQ(written(a), written(b));
}

TEST(Trajectory, AnEmptyProgramIsAWholeFile) {
    Stream s;
    const auto bytes = written(s);
    EXPECT_EQ(player::verify(bytes).status, Status::ok);
    const player::Trajectory t = opened(bytes);
    EXPECT_EQ(t.moves(), 0u);
    EXPECT_FALSE(t.completed());
    EXPECT_NE(t.meta().find("\"producer\": \"test 1.0\""), std::string_view::npos) << t.meta();
}

TEST(Trajectory, EveryFlippedByteIsDetected) {
    Stream s;
    s.rapid(1, 2);
    s.message("ready");
    s.arc({3, 4}, {2, 3}, true);
    auto bytes = written(s);
    ASSERT_EQ(player::verify(bytes).status, Status::ok);
    for (std::size_t i = 0; i < bytes.size(); ++i)
        for (const std::byte flip : {std::byte{0x01}, std::byte{0x80}, std::byte{0xff}}) {
            bytes[i] ^= flip;
            EXPECT_NE(player::verify(bytes).status, Status::ok) << "byte " << i;
            bytes[i] ^= flip;
        }
}

TEST(Trajectory, EveryLengthThatIsTooShortIsDetected) {
    Stream s;
    s.rapid(1, 2);
    s.message("ready");
    s.line(3, 4);
    const auto bytes = written(s);
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        // A copy of its own: the sanitizer sees a byte read behind it.
        const std::vector<std::byte> cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
        EXPECT_EQ(player::verify(cut).status, size < 8 ? Status::not_a_trajectory : Status::truncated) << size;
        player::Trajectory t;
        t.open(cut);
        player::MoveReader reader(t);
        std::uint64_t read = 0;
        while (reader.next()) ++read;
        EXPECT_EQ(read, t.moves()) << size;
    }
}

TEST(Trajectory, ATruncatedFileIsReadableUpToItsLastWholeBlock) {
    Stream s = many(5000);
    auto bytes = written(s);
    const player::Trajectory whole = opened(bytes);
    std::uint64_t moves = 0;
    for (auto block = whole.first_block(); block; block = whole.next_block(*block)) {
        // Cut in the middle of this block: what the blocks before it hold is there, and nothing else.
        const std::vector<std::byte> cut(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(block->next - 8));
        const player::Trajectory t = opened(cut, Status::truncated);
        EXPECT_EQ(t.moves(), moves);
        player::MoveReader reader(t);
        std::uint64_t read = 0;
        while (reader.next()) ++read;
        EXPECT_EQ(read, moves);
        if (block->type == player::Type::moves || block->type == player::Type::wide) moves += block->count;
    }
    EXPECT_EQ(moves, 5000u);
}

TEST(Trajectory, BlocksStandBeforeWhatUsesThem) {
    Stream s = many(30000);
    const auto bytes = written(s);
    const player::Trajectory t = opened(bytes);
    std::uint32_t states = 0, seen = 0;
    for (auto block = t.first_block(); block; block = t.next_block(*block)) {
        EXPECT_LE(block->next - block->offset, block->type == player::Type::index ? 1u << 20 : 65536u);
        if (block->type == player::Type::states) states += block->count;
        if (block->type != player::Type::moves) continue;
        for (std::uint32_t i = 0; i < block->count; ++i, ++seen) {
            player::Move m;
            read_move(record(*block, sizeof(player::Position), i), false, m);
            ASSERT_LT(m.state, states);
        }
    }
    EXPECT_GT(seen, 20000u);
}

TEST(Trajectory, OtherFilesAreNamedAsWhatTheyAre) {
    std::vector<std::byte> bytes(100);
    EXPECT_EQ(player::verify(bytes).status, Status::not_a_trajectory);
    EXPECT_EQ(player::verify({}).status, Status::not_a_trajectory);
    Stream s;
    bytes = written(s);
    bytes[4] = std::byte{'\n'};  // CR LF became LF LF: a text-mode transfer
    EXPECT_EQ(player::verify(bytes).status, Status::not_a_trajectory);
}

TEST(Trajectory, SpindleSpeedsThatNeverRepeatDoNotGrowTheWriter) {
    // 64 situations are remembered; the first one has been forgotten when it comes again and gets a new number.
    Stream s;
    for (int i = 0; i < 100; ++i) {
        s.next.at.speed = i % 70;
        s.line(i, 0);
    }
    const auto bytes = written(s);
    const player::Trajectory t = opened(bytes);
    EXPECT_EQ(t.states(), 100u);
    EXPECT_EQ(player::verify(bytes).status, Status::ok);
}

}  // namespace
}  // namespace fagorc::test
