// Fuzz target of the player: any bytes are a file that is opened, verified, searched and read to its end, and nothing
// outside of them is touched.
#include <cstdint>
#include <cstdlib>

#include "runtime/player/moves.hpp"
#include "runtime/player/verify.hpp"

namespace {

using namespace fagorc::player;

/// Reads a few of everything by number, and numbers that do not exist.
void search(const Trajectory& t) {
    for (std::uint32_t n : {0u, 1u, 7u, none - 1}) {
        if (const auto program = t.program(n)) t.source(n, program->size / 2);
        t.state(n);
        t.chain(n);
        t.event(n);
        t.tool(n);
        t.text(n);
        t.find_move(n);
    }
    t.meta();
    t.first_event_before(t.moves() / 2);
}

/// Moves one after the other; the numbers that they carry count up by one.
void read(const Trajectory& t) {
    std::uint64_t n = 0;
    MoveReader reader(t);
    while (const Move* move = reader.next())
        if (move->number != n++) std::abort();
    MoveReader(t, n / 2).next();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Bytes bytes = std::as_bytes(std::span(data, size));
    Trajectory trajectory;
    const Status status = trajectory.open(bytes);
    const Finding finding = verify(bytes);
    if (finding.status == Status::ok && status != Status::ok) std::abort();
    search(trajectory);
    read(trajectory);
    return 0;
}
