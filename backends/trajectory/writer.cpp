#include "backends/trajectory/writer.hpp"

#include <algorithm>

#include "backends/numbering.hpp"
#include "backends/trajectory/blocks.hpp"
#include "backends/trajectory/meta.hpp"
#include "backends/trajectory/records.hpp"
#include "ir/operation/position.hpp"

namespace fagorc::backends {
namespace {

using namespace trajectory;
using operation::Operation;

/// Records of one kind: the block being filled and the number of its first record.
struct Series {
    Block block;
    std::uint64_t first = 0;
};

class TrajectoryWriter final : public NumberingSink {
  public:
    TrajectoryWriter(const Job& job, Output& output)
        : NumberingSink(job), out_(output), position_(job.tables, job.machine) {
        const std::string meta = meta_text(job);
        Block block(type::meta, 0, 1);
        block.append(meta.data(), std::min(meta.size(), Block::capacity));
        out_.write(block, 0, block.records());
        write_tools();
    }

    void push(const Operation& o) override {
        // A reader finds where the tool stands at the beginning of a block of moves: one begins where it has jumped.
        if (position_.enter(o)) flush();
        std::visit([&](const auto& what) { put(o, what); }, o.what);
    }

    void finish() override {
        flush();
        for (std::uint32_t n = 0; n < programs().size(); ++n) write_source(n);
        EndPayload end;
        end.moves = moves_;
        end.events = events_.first;
        end.states = static_cast<std::uint32_t>(states_.first);
        end.chains = static_cast<std::uint32_t>(chains_.first);
        end.texts = static_cast<std::uint32_t>(texts_.first);
        end.programs = static_cast<std::uint32_t>(programs().size());
        end.flags = completed_ ? completed : 0;
        out_.finish(end);
    }

  private:
    void put(const Operation& o, const operation::Line& l) { move(o, l.rapid ? rapid : line, l.end, {}); }
    void put(const Operation& o, const operation::Arc& a) {
        move(o, a.ccw ? counter_clockwise : clockwise, a.end, a.centre, a.full ? full_turn : 0);
    }
    void put(const Operation& o, const operation::Thread& t) { move(o, thread, t.end, {t.angle, t.lead}); }
    void put(const Operation& o, const operation::Dwell& d) { move(o, dwell, position_.point(), {0, d.seconds}); }
    void put(const Operation& o, const operation::Barrier& b) {
        event(o, barrier_code, {}, static_cast<double>(b.why), 0);
    }
    void put(const Operation& o, const operation::Event& e) {
        using Kind = operation::Event::Kind;
        const auto kind = static_cast<std::uint8_t>(e.kind);
        completed_ = completed_ || e.kind == Kind::program_end;
        if (e.kind != Kind::home) return event(o, kind, e.axes, e.value, e.text);
        position_.home(o, e.axes);
        for (Axis a : all_axes) {
            AxisSet one;
            one.add(a);
            if (e.axes.has(a)) event(o, kind, one, position_.axes()[a], 0);
        }
        flush();  // as in push
    }

    /// `extra`: an arc's centre; v lead and u start angle of a thread; v seconds of a dwell.
    void move(const Operation& o, Kind kind, Point end, Point extra, std::uint8_t flags = 0) {
        const MoveBody body{extra.v,   extra.u, o.at.feed, o.at.line, chain_number(o.at.chain), state_number(o.at),
                            o.at.pass, kind,    flags};
        // A block of wide moves that has begun takes the plain ones too: else two short blocks alternate.
        if (wide_.block.empty() && position_.plane() == plane_g18 && o.moved.empty())
            add_plain(o, end, body);
        else
            add_wide(o, end, body);
        ++moves_;
    }

    void add_plain(const Operation& o, Point end, const MoveBody& body) {
        begin(plain_);
        plain_.block.add<PlainMove>() = {end.v, end.u, body};
        position_.move(o, end);
        if (!plain_.block.has_room(sizeof(PlainMove))) flush();
    }

    void add_wide(const Operation& o, Point end, const MoveBody& body) {
        if (!plain_.block.empty()) flush();
        begin(wide_);
        position_.move(o, end);
        const Plane plane = position_.plane();
        wide_.block.add<WideMove>() = {position_.axes(),
                                       body,
                                       o.moved.bits,
                                       static_cast<std::uint8_t>(plane.u),
                                       static_cast<std::uint8_t>(plane.v),
                                       0};
        if (!wide_.block.has_room(sizeof(WideMove))) flush();
    }

    /// The first move of a block: the block says where the tool stands before it.
    void begin(Series& moves) {
        if (!moves.block.empty()) return;
        moves.first = moves_;
        std::memcpy(moves.block.prefix(), position_.axes().data(), sizeof(PerAxis<double>));
    }

    void event(const Operation& o, std::uint8_t kind, AxisSet axes, double value, std::uint32_t text) {
        const std::uint32_t chain = chain_number(o.at.chain), state = state_number(o.at), string = text_number(text);
        events_.block.add<EventRecord>() = {moves_, value,     o.at.line, chain, state,
                                            string, axes.bits, o.at.pass, kind,  {}};
        if (!events_.block.has_room(sizeof(EventRecord))) flush();
    }

    void new_program(std::uint32_t, diag::FileId) override {}  // its text comes at the end, when all of it is known
    void new_chain(std::uint32_t, std::uint32_t program, std::uint32_t caller, std::uint32_t line) override {
        chains_.block.add<ChainRecord>() = {program, caller, line, 0};
        if (!chains_.block.has_room(sizeof(ChainRecord))) flush();
    }
    void new_state(std::uint32_t, const Situation& s) override {
        states_.block.add<StateRecord>() = state_record(job().tables, s);
        if (!states_.block.has_room(sizeof(StateRecord))) flush();
    }
    void new_text(std::uint32_t, std::string_view text) override {
        text = text.substr(0, Block::capacity - sizeof(std::uint32_t));
        const auto size = static_cast<std::uint32_t>(text.size());
        if (!texts_.block.has_room(sizeof size + size)) flush();
        texts_.block.append(&size, sizeof size);
        texts_.block.append(text.data(), size);
        ++texts_in_block_;
    }

    /// Everything that is waiting, in an order in which nothing is used before it has been read.
    void flush() {
        write(chains_);
        if (!texts_.block.empty()) out_.write(texts_.block, texts_.first, texts_in_block_);
        texts_.first += std::exchange(texts_in_block_, 0);
        write(states_);
        write(events_);
        write(plain_);
        write(wide_);
    }

    void write(Series& s) {
        if (s.block.empty()) return;
        const std::uint32_t count = s.block.records();
        out_.write(s.block, s.first, count);
        s.first += count;
    }

    void write_tools() {
        Series tools{Block(type::tools, 0, sizeof(ToolRecord))};
        for (const ToolRecord& row : tool_rows(job().machine)) {
            tools.block.add<ToolRecord>() = row;
            if (!tools.block.has_room(sizeof row)) write(tools);
        }
        write(tools);
    }

    /// The whole text of a program in chunks, each with its name.
    void write_source(std::uint32_t number) {
        const diag::FileId file = programs()[number];
        const std::string_view name = base_name(job().programs.name(file)).substr(0, longest_name);
        const std::size_t size = job().programs.text(file).size();
        const SourcePrefix prefix{size, number, static_cast<std::uint32_t>(name.size())};
        std::size_t at = 0;
        do {
            Block block(type::source, 0, 1, sizeof prefix);
            std::memcpy(block.prefix(), &prefix, sizeof prefix);
            block.append(name.data(), name.size());
            const std::string_view chunk =
                job().programs.text(file, at).substr(0, Block::capacity - sizeof prefix - name.size());
            block.append(chunk.data(), chunk.size());
            out_.write(block, at, static_cast<std::uint32_t>(chunk.size()));
            at += chunk.size();
        } while (at < size);
    }

    static constexpr std::size_t longest_name = 4096;

    BlockWriter out_;
    Series chains_{Block(type::chains, critical, sizeof(ChainRecord))};
    Series texts_{Block(type::strings, critical, 0)};
    Series states_{Block(type::states, critical, sizeof(StateRecord))};
    Series events_{Block(type::events, critical, sizeof(EventRecord))};
    Series plain_{Block(type::moves, critical, sizeof(PlainMove), sizeof(PerAxis<double>))};
    Series wide_{Block(type::wide, critical, sizeof(WideMove), sizeof(PerAxis<double>))};
    std::uint32_t texts_in_block_ = 0;
    std::uint64_t moves_ = 0;

    operation::Position position_;
    bool completed_ = false;
};

}  // namespace

std::unique_ptr<operation::Sink> make_trajectory_writer(const Job& job, Output& output) {
    return std::make_unique<TrajectoryWriter>(job, output);
}

}  // namespace fagorc::backends
