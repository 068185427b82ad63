// fagorc verify FILE.ftj: checks every block of a trajectory file.
#include "runtime/player/verify.hpp"

#include "tools/fagorc/trajectory/trajectory.hpp"

namespace fagorc::tool {
namespace {

/// The type of a block as its four letters; what is no letter is shown by its value.
std::string letters(std::uint32_t type) {
    std::string out;
    for (int i = 0; i < 4; ++i) {
        const auto c = static_cast<unsigned char>(type >> (8 * i));
        out += c >= ' ' && c <= '~' ? std::string(1, static_cast<char>(c)) : '<' + std::to_string(c) + '>';
    }
    return out;
}

/// The type of block `n`.
std::string type_of_block(player::Bytes file, std::uint64_t n) {
    auto block = player::block_at(file, player::file_header_size);
    for (; block && n > 0; --n) block = player::block_at(file, block->next);
    return block ? letters(static_cast<std::uint32_t>(block->type)) : std::string{};
}

}  // namespace

bool verify_trajectory(const std::string& name, player::Bytes file, diag::Sink& out) {
    const player::Finding finding = player::verify(file);
    const std::string block = std::to_string(finding.block);
    switch (finding.status) {
        case player::Status::ok:
            return true;
        case player::Status::not_a_trajectory:
            out.report(diag::Id::trajectory_bad_magic, {}, name);
            break;
        case player::Status::newer_version:
            out.report(diag::Id::trajectory_version, {}, player::load<std::uint16_t>(file.data() + 8), 1);
            break;
        case player::Status::truncated:
            out.report(diag::Id::trajectory_truncated, {}, block);
            break;
        case player::Status::damaged:
            out.report(diag::Id::trajectory_bad_hash, {}, block);
            break;
        case player::Status::unknown_block:
            out.report(diag::Id::trajectory_unknown_block, {}, block, type_of_block(file, finding.block));
            break;
        case player::Status::malformed:
            out.report(diag::Id::trajectory_malformed, {}, block, finding.what);
            break;
    }
    return false;
}

}  // namespace fagorc::tool
