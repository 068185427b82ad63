// The bytes of a trajectory file as the writer lays them down (docs/trajectory-format.md). The player reads by offsets
// of its own: it shares nothing with the compiler but the document.
#pragma once

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace fagorc::backends::trajectory {

static_assert(std::endian::native == std::endian::little, "records are written as they lie in memory");

/// The type of a block: four letters that can be read in a hexdump.
constexpr std::uint32_t four(const char (&s)[5]) {
    std::uint32_t v = 0;
    for (int i = 3; i >= 0; --i) v = v << 8 | static_cast<unsigned char>(s[i]);
    return v;
}

namespace type {
inline constexpr std::uint32_t meta = four("META"), source = four("SRCE"), strings = four("STRS"),
                               chains = four("CALL"), tools = four("TOOL"), states = four("STAT"),
                               events = four("EVNT"), moves = four("MOVE"), wide = four("WIDE"), index = four("INDX"),
                               end = four("END ");
}  // namespace type

/// "\x89FTJ\r\n\x1a\n": a transfer that changes line ends or strips the eighth bit changes it.
inline constexpr std::array<unsigned char, 8> magic = {0x89, 'F', 'T', 'J', '\r', '\n', 0x1a, '\n'};
inline constexpr std::uint16_t major_version = 1, minor_version = 0;

struct FileHeader {
    std::array<unsigned char, 8> magic{};
    std::uint16_t major = 0, minor = 0;
    std::uint32_t check = 0;  ///< low half of the XXH3-64 of the twelve bytes before it
};

/// A reader that does not know the type of a block may not leave it out.
inline constexpr std::uint16_t critical = 1;

struct BlockHeader {
    std::uint32_t type = 0;
    std::uint16_t flags = 0, record_size = 0;
    std::uint32_t count = 0, payload = 0;  ///< records; bytes after the header, without the padding to 8
    std::uint64_t first = 0;               ///< number of the first record among all of its kind
    std::uint64_t hash = 0;
};

/// A whole block with its header.
inline constexpr std::size_t block_size = 65536;
inline constexpr std::uint32_t none = 0xffffffff;

/// What every move has; `p` and `q` by its kind: an arc's centre on the ordinate and abscissa (X and Z of a lathe), a
/// thread's lead and start angle, a dwell's seconds and 0.
struct MoveBody {
    double p = 0, q = 0, feed = 0;
    std::uint32_t line = 0, chain = 0, state = 0;
    std::uint16_t pass = 0;
    std::uint8_t kind = 0, flags = 0;
};

/// A move of X and Z in the plane ZX.
struct PlainMove {
    double x = 0, z = 0;
    MoveBody body;
};

/// A move in another plane or of other axes.
struct WideMove {
    std::array<double, 9> end{};
    MoveBody body;
    std::uint16_t moved = 0;  ///< axes outside the plane that move
    std::uint8_t plane_u = 0, plane_v = 0;
    std::uint32_t reserved = 0;
};

enum Kind : std::uint8_t { rapid, line, clockwise, counter_clockwise, thread, dwell };
inline constexpr std::uint8_t full_turn = 1;

struct StateRecord {
    std::array<double, 9> origin{};
    double speed = 0, speed_limit = 0, nose = 0, length_x = 0, length_z = 0;
    double acceleration = 0, contour_error = 0, corner_angle = 0;
    std::uint16_t tool = 0, offset = 0;
    std::uint8_t gear = 0, tip = 0, turn = 0, flags = 0;
    std::uint8_t motion = 0, plane_code = 0, plane_u = 0, plane_v = 0, distance = 0, unit = 0, x_word = 0;
    std::uint8_t feed_mode = 0, speed_mode = 0, spindle = 0, corner = 0, side = 0;
    std::uint32_t reserved = 0;
};
enum StateFlags : std::uint8_t { machine_frame = 1, stop_disabled = 2, feed_hold_disabled = 4, joined_blocks = 8 };

struct ChainRecord {
    std::uint32_t program = none, caller = none, caller_line = 0, reserved = 0;
};

struct EventRecord {
    std::uint64_t before = 0;  ///< number of the move that it comes before
    double value = 0;
    std::uint32_t line = 0, chain = 0, state = 0, text = none;
    std::uint16_t axes = 0, pass = 0;
    std::uint8_t kind = 0;
    std::array<std::uint8_t, 3> reserved{};
};

struct ToolRecord {
    double x = 0, z = 0, nose = 0, wear_x = 0, wear_z = 0, insert_angle = 0, insert_width = 0, cutting_angle = 0;
    std::uint16_t tool = 0, offset = 0, family = 0, pocket = 0xffff;
    std::uint8_t tip = 0;
    std::array<std::uint8_t, 7> reserved{};
};

/// Before the name and the piece of text of a SRCE block.
struct SourcePrefix {
    std::uint64_t size = 0;               ///< of the whole text
    std::uint32_t program = 0, name = 0;  ///< number of the program, bytes of its name
};

struct IndexRecord {
    std::uint64_t offset = 0;
    std::uint32_t type = 0, count = 0;
    std::uint64_t first = 0;
    std::uint32_t number = 0, flags = 0;
};

struct EndPayload {
    std::uint64_t index_offset = 0, blocks = 0, moves = 0, events = 0;
    std::uint32_t states = 0, chains = 0, texts = 0, programs = 0, flags = 0, reserved = 0;
};
inline constexpr std::uint32_t completed = 1;

static_assert(sizeof(FileHeader) == 16 && sizeof(BlockHeader) == 32 && sizeof(PlainMove) == 56 &&
              sizeof(WideMove) == 120 && sizeof(StateRecord) == 160 && sizeof(ChainRecord) == 16 &&
              sizeof(EventRecord) == 40 && sizeof(ToolRecord) == 80 && sizeof(IndexRecord) == 32 &&
              sizeof(EndPayload) == 56 && sizeof(SourcePrefix) == 16 && sizeof(MoveBody) == 40);
static_assert(std::has_unique_object_representations_v<BlockHeader> &&
              std::has_unique_object_representations_v<ChainRecord> &&
              std::has_unique_object_representations_v<IndexRecord> &&
              std::has_unique_object_representations_v<EndPayload>);

}  // namespace fagorc::backends::trajectory
