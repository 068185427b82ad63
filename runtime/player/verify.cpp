#include "runtime/player/verify.hpp"

namespace fagorc::player {
namespace {

class Verifier {
  public:
    explicit Verifier(const Trajectory& trajectory) : file_(trajectory.file()), trajectory_(trajectory) {}

    Finding run() {
        std::uint64_t offset = file_header_size;
        for (;; ++number_) {
            const auto block = block_at(file_, offset);
            if (!block) return {Status::truncated, number_, ""};
            if (!intact(file_, *block, number_)) return {Status::damaged, number_, ""};
            if (const char* what = wrong(*block)) return {Status::malformed, number_, what};
            offset = block->next;
            if (block->type == Type::end) return finished(offset);
        }
    }

  private:
    Finding finished(std::uint64_t offset) const {
        const char* what = offset != file_.size()                 ? "bytes follow the end"
                           : number_ + 1 != trajectory_.blocks()  ? "number of blocks"
                           : moves_ != trajectory_.moves()        ? "number of moves"
                           : events_ != trajectory_.events()      ? "number of events"
                           : states_ != trajectory_.states()      ? "number of states"
                           : chains_ != trajectory_.chains()      ? "number of call chains"
                           : texts_ != trajectory_.texts()        ? "number of texts"
                           : indexed_ + 2 != trajectory_.blocks() ? "number of index entries"
                                                                  : nullptr;
        return what ? Finding{Status::malformed, number_, what} : Finding{};
    }

    /// What is wrong with an intact block; null where nothing is.
    const char* wrong(const Block& b) {
        if (!well_formed(b)) return "sizes disagree";
        for (std::uint64_t i = b.offset + block_header_size + b.payload.size(); i < b.next; ++i)
            if (file_[i] != std::byte{0}) return "padding";
        switch (b.type) {
            case Type::moves:
            case Type::wide:
                return wrong_moves(b);
            case Type::events:
                return wrong_events(b);
            case Type::chains:
                return wrong_chains(b);
            case Type::states:
                return in_order(b, states_);
            case Type::texts:
                return in_order(b, texts_);
            case Type::index:
                indexed_ = b.count;
                return wrong_index(b);
            case Type::meta:
            case Type::source:
            case Type::tools:
            case Type::live:
            case Type::picture:
            case Type::end:
                break;
        }
        return nullptr;
    }

    template <class Counter>
    const char* in_order(const Block& b, Counter& counter) {
        if (b.first != counter) return "records are missing";
        counter = static_cast<Counter>(counter + b.count);
        return nullptr;
    }

    const char* wrong_moves(const Block& b) {
        Move m;
        for (std::uint64_t i = 0; i < b.count; ++i) {
            read_move(record(b, sizeof(Position), i), b.type == Type::wide, m);
            if (m.state >= states_ || m.chain >= chains_) return "a move refers to a later state or call chain";
            if (m.kind > Kind::dwell) return "unknown kind of move";
            if (m.plane_u >= axis_count || m.plane_v >= axis_count || m.plane_u == m.plane_v) return "plane of a move";
        }
        return in_order(b, moves_);
    }

    const char* wrong_events(const Block& b) {
        for (std::uint64_t i = 0; i < b.count; ++i) {
            const Event e = read_event(record(b, 0, i));
            if (e.state >= states_ || e.chain >= chains_ || (e.text != none && e.text >= texts_))
                return "an event refers to a later state, call chain or text";
            if (e.before < before_) return "events are out of order";
            before_ = e.before;
            if (e.before < moves_) return "an event comes after its move";
        }
        return in_order(b, events_);
    }

    const char* wrong_chains(const Block& b) {
        for (std::uint64_t i = 0; i < b.count; ++i) {
            const Chain c = read_chain(record(b, 0, i));
            if (c.caller != none && c.caller >= b.first + i) return "a call chain refers to a later one";
            if (c.program != none && c.program >= trajectory_.programs()) return "a call chain refers to no program";
        }
        return in_order(b, chains_);
    }

    /// Each entry names a block of its type; a block too few or twice shows in their number and order.
    const char* wrong_index(const Block& index) {
        std::uint32_t type = 0, number = 0;
        std::uint64_t offset = 0;
        for (std::uint64_t i = 0; i < index.count; ++i) {
            const std::byte* p = record(index, 0, i);
            const auto block = block_at(file_, load<std::uint64_t>(p));
            const auto entry_type = load<std::uint32_t>(p + 8);
            if (!block || block->offset >= index.offset || static_cast<std::uint32_t>(block->type) != entry_type ||
                block->count != load<std::uint32_t>(p + 12) || block->first != load<std::uint64_t>(p + 16) ||
                block->flags != load<std::uint32_t>(p + 28))
                return "an index entry disagrees with its block";
            if (entry_type < type ||
                (entry_type == type && (block->offset <= offset || load<std::uint32_t>(p + 24) <= number)))
                return "the index is out of order";
            type = entry_type;
            offset = block->offset;
            number = load<std::uint32_t>(p + 24);
        }
        return nullptr;
    }

    Bytes file_;
    const Trajectory& trajectory_;
    std::uint64_t number_ = 0, moves_ = 0, events_ = 0, before_ = 0, indexed_ = 0;
    std::uint32_t states_ = 0, chains_ = 0, texts_ = 0;
};

}  // namespace

Finding verify(Bytes file) {
    Trajectory trajectory;
    const Status status = trajectory.open(file);
    if (status == Status::ok) return Verifier(trajectory).run();
    return {status, trajectory.blocks(), ""};
}

}  // namespace fagorc::player
