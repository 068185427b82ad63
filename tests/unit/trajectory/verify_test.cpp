// `fagorc verify` names each fault by its own diagnostic, with the number of the block. Where a fault is not one of
// single bytes the hashes are made right again, as another writer would make them.
#include <gtest/gtest.h>

#include <cstring>

#include "backends/trajectory/writer.hpp"
#include "ir/diag/catalogue.hpp"
#include "runtime/player/xxh3.hpp"
#include "tests/support/stream.hpp"
#include "tools/fagorc/trajectory/trajectory.hpp"

namespace fagorc::test {
namespace {

using player::Block;
using player::Type;

class VerifyFile : public testing::Test {
  protected:
    VerifyFile() {
        Stream s = everything();
        backends::MemoryOutput output;
        s.play(*backends::make_trajectory_writer(s.job(), output));
        file_ = output.bytes();
    }

    /// The first block of a type, and its number in the file.
    struct Found {
        Block block;
        std::uint64_t number = 0;
    };
    Found find(Type type) const {
        Found found{*player::block_at(file_, player::file_header_size)};
        for (; found.block.type != type; ++found.number) found.block = *player::block_at(file_, found.block.next);
        return found;
    }

    template <class T>
    void put(std::uint64_t at, T value) {
        std::memcpy(file_.data() + at, &value, sizeof value);
    }

    /// Makes the hash of a block right: over all its bytes with the hash field zero, the seed is its number.
    void seal(const Found& f) {
        put(f.block.offset + 24, std::uint64_t{0});
        const player::Bytes bytes = player::Bytes(file_).subspan(f.block.offset, f.block.next - f.block.offset);
        put(f.block.offset + 24, player::xxh3_64(bytes, f.number));
    }

    void expect(diag::Id id, const std::string& message) {
        Findings findings;
        EXPECT_FALSE(tool::verify_trajectory("x.ftj", file_, findings));
        ASSERT_EQ(findings.list.size(), 1u);
        EXPECT_EQ(findings.list[0].id, id);
        EXPECT_EQ(diag::message(findings.list[0], Language::english), message);
    }

    std::vector<std::byte> file_;
};

TEST_F(VerifyFile, ASoundFileIsSound) {
    Findings findings;
    EXPECT_TRUE(tool::verify_trajectory("x.ftj", file_, findings));
    EXPECT_TRUE(findings.list.empty());
}

TEST_F(VerifyFile, BadMagic) {
    put(0, 'G');
    expect(diag::Id::trajectory_bad_magic, "x.ftj is not a trajectory file");
}

TEST_F(VerifyFile, NewerVersion) {
    put(8, std::uint16_t{2});
    put(12, static_cast<std::uint32_t>(player::xxh3_64(player::Bytes(file_).first(12))));
    expect(diag::Id::trajectory_version, "the trajectory file has version 2, this program reads up to 1");
}

TEST_F(VerifyFile, BadHash) {
    const Found moves = find(Type::moves);
    file_[moves.block.offset + player::block_header_size + 80] ^= std::byte{1};
    expect(diag::Id::trajectory_bad_hash,
           "block " + std::to_string(moves.number) + " of the trajectory file is damaged");
}

TEST_F(VerifyFile, Truncated) {
    const Found moves = find(Type::moves);
    file_.resize(moves.block.next - 8);
    expect(diag::Id::trajectory_truncated,
           "the trajectory file is cut off at block " + std::to_string(moves.number));
}

TEST_F(VerifyFile, UnknownCriticalBlock) {
    const Found chains = find(Type::chains), index = find(Type::index);
    put(chains.block.offset, std::array{'N', 'E', 'W', '1'});
    seal(chains);
    for (std::uint32_t i = 0; i < index.block.count; ++i) {
        const std::uint64_t entry = index.block.offset + player::block_header_size + 32 * i;
        if (player::load<std::uint64_t>(file_.data() + entry) == chains.block.offset)
            put(entry + 8, std::array{'N', 'E', 'W', '1'});
    }
    seal(index);
    expect(diag::Id::trajectory_unknown_block,
           "block " + std::to_string(chains.number) +
               " of the trajectory file has the unknown type NEW1 and cannot be left out");
}

TEST_F(VerifyFile, Malformed) {
    const Found moves = find(Type::moves);
    // Behind the nine coordinates of the start: the kind of the first record is its byte 54
    // (docs/trajectory-format.md).
    put(moves.block.offset + player::block_header_size + 72 + 54, std::uint8_t{99});
    seal(moves);
    expect(diag::Id::trajectory_malformed,
           "block " + std::to_string(moves.number) + " of the trajectory file is malformed: unknown kind of move");
}

}  // namespace
}  // namespace fagorc::test
