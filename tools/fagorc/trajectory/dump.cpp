// fagorc dump FILE.ftj: what a trajectory file holds, as text or as a table.
#include <fmt/format.h>

#include <array>
#include <iterator>

#include "runtime/player/trajectory.hpp"
#include "tools/fagorc/report/readable.hpp"
#include "tools/fagorc/trajectory/trajectory.hpp"

namespace fagorc::tool {
namespace {

using namespace player;

constexpr std::string_view axis_letters = "XYZUVWABC";

char axis(std::uint8_t n) {
    return n < axis_count ? axis_letters[n] : '?';
}

std::string_view name(Kind kind) {
    static constexpr std::array<std::string_view, 6> names = {"rapid", "line", "cw", "ccw", "thread", "dwell"};
    const auto n = static_cast<std::size_t>(kind);
    return n < names.size() ? names[n] : "?";
}

std::string_view event_name(std::uint8_t kind) {
    static constexpr std::array<std::string_view, 10> names = {"misc",         "spindle_angle", "live_tool", "tool",
                                                               "offset",       "message",       "error",     "home",
                                                               "graphic_zone", "program_end"};
    return kind < names.size() ? names[kind] : kind == 255 ? "stop" : "?";
}

std::string axes(const Position& p) {
    std::string out;
    for (std::uint8_t a = 0; a < axis_count; ++a) out += fmt::format(" {}{}", axis(a), p[a]);
    return out;
}

class Dump {
  public:
    Dump(Bytes file, backends::Output& output) : file_(file), output_(output) {}

    void run() {
        std::uint64_t number = 0;
        auto block = block_at(file_, file_header_size);
        for (; block && intact(file_, *block, number); block = block_at(file_, block->next), ++number) {
            head(*block, number);
            if (well_formed(*block)) body(*block);
            output_.write(text_);
            text_.clear();
        }
    }

  private:
    template <class... Arguments>
    void line(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
        fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
        text_ += '\n';
    }

    void head(const Block& b, std::uint64_t number) {
        std::string type;
        for (int i = 0; i < 4; ++i) type += static_cast<char>(static_cast<std::uint32_t>(b.type) >> (8 * i));
        line("block {} {} offset {} count {} first {} payload {} record {} flags {} hash {:016x}", number,
             report::readable(type), b.offset, b.count, b.first, b.payload.size(), b.record_size, b.flags, b.hash);
    }

    void body(const Block& b) {
        switch (b.type) {
            case Type::meta:
                return quoted("meta", b.payload);
            case Type::source: {
                const auto name = load<std::uint32_t>(b.payload.data() + 12);
                line("source {} size {}", load<std::uint32_t>(b.payload.data() + 8),
                     load<std::uint64_t>(b.payload.data()));
                quoted("name", b.payload.subspan(16, name));
                return quoted("text", b.payload.subspan(16 + name));
            }
            case Type::texts:
                return texts(b);
            case Type::moves:
            case Type::wide:
                line("from{}", axes(read_position(b.payload.data())));
                break;
            case Type::end:
                return end(b.payload.data());
            case Type::chains:
            case Type::tools:
            case Type::states:
            case Type::events:
            case Type::index:
                break;
            case Type::live:
            case Type::picture:
                return;
        }
        const auto layout = layout_of(b.type);
        if (!layout) return;
        for (std::uint32_t i = 0; i < b.count; ++i) one(b, b.first + i, record(b, layout->prefix, i));
    }

    void one(const Block& b, std::uint64_t n, const std::byte* p) {
        switch (b.type) {
            case Type::moves:
            case Type::wide:
                return move(n, p, b.type == Type::wide);
            case Type::events: {
                const Event e = read_event(p);
                std::string moved;
                for (std::uint8_t a = 0; a < axis_count; ++a)
                    if (e.axes >> a & 1) moved += axis(a);
                return line("event {} before {} {} value {} axes {} text {} line {} pass {} chain {} state {}", n,
                            e.before, event_name(e.kind), e.value, moved.empty() ? "-" : moved, number(e.text), e.line,
                            e.pass, e.chain, e.state);
            }
            case Type::chains: {
                const Chain c = read_chain(p);
                return line("chain {} program {} caller {} line {}", n, number(c.program), number(c.caller),
                            c.caller_line);
            }
            case Type::states:
                return state(n, read_state(p));
            case Type::tools: {
                const Tool t = read_tool(p);
                return line("tool {} offset {} family {} pocket {} X{} Z{} R{} F{} I{} K{} NOSEA{} NOSEW{} CUTA{}",
                            t.tool, t.offset, t.family, t.pocket == 0xffff ? "-" : std::to_string(t.pocket), t.x, t.z,
                            t.nose, t.tip, t.wear_x, t.wear_z, t.insert_angle, t.insert_width, t.cutting_angle);
            }
            case Type::index:
                return line("entry {} block {} offset {} first {} count {}", n, load<std::uint32_t>(p + 24),
                            load<std::uint64_t>(p), load<std::uint64_t>(p + 16), load<std::uint32_t>(p + 12));
            case Type::meta:
            case Type::source:
            case Type::texts:
            case Type::live:
            case Type::picture:
            case Type::end:
                return;
        }
    }

    void move(std::uint64_t n, const std::byte* p, bool wide) {
        Move m;
        read_move(p, wide, m);
        std::string what = wide ? axes(m.end) : fmt::format(" X{} Z{}", m.end[axis_x], m.end[axis_z]);
        if (m.kind == Kind::clockwise || m.kind == Kind::counter_clockwise)
            what += fmt::format(" centre {}{} {}{}{}", axis(m.plane_u), m.centre_u, axis(m.plane_v), m.centre_v,
                                m.full_turn ? " full" : "");
        if (m.kind == Kind::thread) what += fmt::format(" lead {} angle {}", m.lead, m.start_angle);
        if (m.kind == Kind::dwell) what += fmt::format(" seconds {}", m.seconds);
        line("move {} {}{} feed {} line {} pass {} chain {} state {}", n, name(m.kind), what, m.feed, m.line, m.pass,
             m.chain, m.state);
    }

    void state(std::uint64_t n, const State& s) {
        line("state {} tool {} offset {} plane {}{} feed_mode {} speed {} speed_mode {} turn {} origin{}{}", n, s.tool,
             s.offset, axis(s.plane_u), axis(s.plane_v), s.feed_mode, s.speed, s.speed_mode, s.turn, axes(s.origin),
             s.machine_frame ? " machine" : "");
        line(
            "  motion {} plane_code {} distance {} unit {} x {} spindle {} corner {} side {} gear {} tip {} nose {} "
            "length X{} Z{} limit {}",
            s.motion, s.plane_code, s.distance, s.unit, s.x_word, s.spindle, s.corner, s.side, s.gear, s.tip, s.nose,
            s.length_x, s.length_z, s.speed_limit);
        line("  look-ahead {} {} {} stop_disabled {} feed_hold_disabled {} joined {}", s.acceleration, s.contour_error,
             s.corner_angle, s.stop_disabled, s.feed_hold_disabled, s.joined_blocks);
    }

    void texts(const Block& b) {
        std::size_t at = 0;
        for (std::uint32_t i = 0; i < b.count; ++i) {
            const auto size = load<std::uint32_t>(b.payload.data() + at);
            quoted(fmt::format("text {}", b.first + i), b.payload.subspan(at + sizeof size, size));
            at += sizeof size + size;
        }
    }

    void end(const std::byte* p) {
        line("end index {} blocks {} moves {} events {} states {} chains {} texts {} programs {} flags {}",
             load<std::uint64_t>(p), load<std::uint64_t>(p + 8), load<std::uint64_t>(p + 16),
             load<std::uint64_t>(p + 24), load<std::uint32_t>(p + 32), load<std::uint32_t>(p + 36),
             load<std::uint32_t>(p + 40), load<std::uint32_t>(p + 44), load<std::uint32_t>(p + 48));
    }

    /// A text with its name, each of its lines behind a bar: whatever it holds, it looks like no record.
    void quoted(std::string_view what, Bytes bytes) {
        std::string_view text{reinterpret_cast<const char*>(bytes.data()), bytes.size()};
        line("{}", what);
        while (!text.empty()) {
            const std::size_t end = text.find('\n');
            line("  |{}", report::readable(text.substr(0, end)));
            text.remove_prefix(end == text.npos ? text.size() : end + 1);
        }
    }

    static std::string number(std::uint32_t n) { return n == none ? "-" : std::to_string(n); }

    Bytes file_;
    backends::Output& output_;
    std::string text_;
};

}  // namespace

bool dump_trajectory(const std::string& name, Bytes file, backends::Output& output, diag::Sink& out) {
    Trajectory trajectory;
    const Status status = trajectory.open(file);
    if (status != Status::not_a_trajectory && status != Status::newer_version && file.size() >= file_header_size)
        Dump(file, output).run();
    return verify_trajectory(name, file, out);
}

}  // namespace fagorc::tool
