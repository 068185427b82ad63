#include "tools/fagorc/trajectory/replay.hpp"

#include <nlohmann/json.hpp>

#include "frontend/controls/controls.hpp"
#include "runtime/player/moves.hpp"

namespace fagorc::tool {
namespace {

using Json = nlohmann::json;

/// The code of a stop of block preparation among the events.
constexpr std::uint8_t barrier_code = 255;

template <class T>
T value_or(const Json& object, const char* key, T otherwise) {
    const auto at = object.find(key);
    if (at == object.end()) return otherwise;
    if constexpr (std::is_same_v<T, std::string>)
        return at->is_string() ? at->get<std::string>() : otherwise;
    else
        return at->is_number() ? at->get<T>() : otherwise;
}

Json object_in(const Json& object, const char* key) {
    const auto at = object.find(key);
    return at != object.end() && at->is_object() ? *at : Json::object();
}

PerAxis<double> per_axis(const player::Position& p) {
    PerAxis<double> out{};
    std::copy(p.begin(), p.end(), out.begin());
    return out;
}

operation::State state_of(const player::State& s) {
    operation::State out;
    program::Modal& m = out.modal;
    m.motion = static_cast<program::Motion>(s.motion);
    m.plane_code = static_cast<program::PlaneCode>(s.plane_code);
    m.plane = {static_cast<Axis>(s.plane_u), static_cast<Axis>(s.plane_v)};
    m.distance = static_cast<program::Distance>(s.distance);
    m.unit = static_cast<program::LengthUnit>(s.unit);
    m.x = static_cast<program::XWord>(s.x_word);
    m.feed = static_cast<program::FeedMode>(s.feed_mode);
    m.speed = static_cast<program::SpeedMode>(s.speed_mode);
    m.spindle = static_cast<program::Spindle>(s.spindle);
    m.corner = static_cast<program::Corner>(s.corner);
    m.side = static_cast<program::Side>(s.side);
    out.tool = s.tool;
    out.offset = s.offset;
    out.gear = s.gear;
    out.tip = s.tip;
    out.turn = static_cast<operation::SpindleTurn>(s.turn);
    out.stop_disabled = s.stop_disabled;
    out.feed_hold_disabled = s.feed_hold_disabled;
    out.single_block_joined = s.joined_blocks;
    out.nose = s.nose;
    out.length_x = s.length_x;
    out.length_z = s.length_z;
    out.speed_limit = s.speed_limit;
    out.look_ahead = {s.acceleration, s.contour_error, s.corner_angle};
    return out;
}

/// Whether two records are of one event.
bool belongs(const player::Event& a, const player::Event& b) {
    return a.kind == b.kind && a.before == b.before && a.line == b.line && a.chain == b.chain && a.state == b.state &&
           a.pass == b.pass;
}

operation::What what_of(const player::Move& m) {
    const Point end{m.end[m.plane_u], m.end[m.plane_v]};
    switch (m.kind) {
        case player::Kind::rapid:
        case player::Kind::line:
            break;
        case player::Kind::clockwise:
        case player::Kind::counter_clockwise:
            return operation::Arc{
                end, {m.centre_u, m.centre_v}, m.kind == player::Kind::counter_clockwise, m.full_turn};
        case player::Kind::thread:
            return operation::Thread{end, m.lead, m.start_angle};
        case player::Kind::dwell:
            return operation::Dwell{m.seconds};
    }
    return operation::Line{end, m.kind == player::Kind::rapid};
}

}  // namespace

Replay::Replay(const player::Trajectory& trajectory) : trajectory_(trajectory) {
    read_meta();
    read_states();
    for (std::uint32_t n = 0; n < trajectory.chains(); ++n) {
        const player::Chain c = trajectory.chain(n).value_or(player::Chain{});
        const auto file = c.program == player::none ? diag::FileId::none : static_cast<diag::FileId>(c.program);
        const bool root = c.caller >= chains_.size();
        const operation::Chain chain{file, root ? operation::ChainId{} : chains_[c.caller], root ? 0 : c.caller_line};
        chains_.push_back(tables_.chains.intern(chain));
    }
    for (std::uint32_t n = 0; n < trajectory.texts(); ++n) texts_.emplace_back(trajectory.text(n));
    read_sources();
}

void Replay::read_sources() {
    if (const control::Dialect* dialect = frontend::dialect(machine_.control))
        workspace_ = std::make_unique<frontend::Workspace>(*dialect, deaf_);
    for (std::uint32_t n = 0; n < trajectory_.programs(); ++n) {
        Source& source = sources_.emplace_back();
        if (const auto program = trajectory_.program(n)) source.name = program->name;
        for (std::string_view piece; !(piece = trajectory_.source(n, source.text.size())).empty();)
            source.text += piece;
        if (workspace_) source.program = &workspace_->add(source.name, source.text);
    }
}

void Replay::read_meta() {
    const Json meta = Json::parse(trajectory_.meta(), nullptr, false);
    if (!meta.is_object()) return;
    producer_ = value_or<std::string>(meta, "producer", {});
    machine_.control = value_or<std::string>(meta, "control", {});
    const Json machine = object_in(meta, "machine"), axes = object_in(machine, "axes"),
               start = object_in(meta, "start"), position = object_in(start, "position");
    machine_.source = value_or<std::string>(machine, "name", {});
    machine_.start_tool = value_or<std::uint16_t>(start, "tool", 0);
    machine_.start_offset = value_or<std::uint16_t>(start, "offset", 0);
    for (Axis a : all_axes) {
        const std::string name(1, letter(a));
        machine_.axes[a].exists = axes.contains(name);
        machine_.axes[a].max_feed = value_or(object_in(axes, name.c_str()), "max_feed", machine_.axes[a].max_feed);
        machine_.start[a] = value_or(position, name.c_str(), 0.0);
    }
}

void Replay::read_states() {
    for (std::uint32_t n = 0; n < trajectory_.states(); ++n) {
        const player::State s = trajectory_.state(n).value_or(player::State{});
        situations_.push_back({tables_.states.intern(state_of(s)),
                               tables_.frames.intern({per_axis(s.origin), s.machine_frame}), s.speed});
    }
}

backends::Job Replay::job(diag::Sink& diagnostics) const {
    return {tables_, texts_, machine_, *this, diagnostics, producer_};
}

std::string_view Replay::name(diag::FileId file) const {
    const auto n = static_cast<std::size_t>(file);
    return n < sources_.size() ? std::string_view(sources_[n].name) : std::string_view{};
}

std::string_view Replay::text(diag::FileId file, std::size_t from) const {
    const auto n = static_cast<std::size_t>(file);
    return n < sources_.size() ? std::string_view(sources_[n].text).substr(from) : std::string_view{};
}

std::optional<std::uint32_t> Replay::label(const operation::Context& at) const {
    const auto n = static_cast<std::size_t>(tables_.chains[at.chain].program);
    return n < sources_.size() && sources_[n].program ? sources_[n].program->label_of_line(at.line) : std::nullopt;
}

void Replay::run(operation::Sink& sink, const bool* stop) const {
    player::MoveReader moves(trajectory_);
    std::uint64_t event = 0;
    bool good = true;
    const player::Move* move = moves.next();
    for (auto next = trajectory_.event(0); good && (move || next);) {
        if (stop && *stop) return;
        if (next && (!move || next->before <= move->number)) {
            good = push_event(event, sink);
            next = trajectory_.event(event);
        } else {
            good = push_move(*move, sink);
            move = moves.next();
        }
    }
    sink.finish();
}

/// False where a number refers to nothing: the rest of the file cannot be trusted.
bool Replay::context(std::uint32_t chain, std::uint32_t state, operation::Context& at) const {
    if (state >= situations_.size() || chain >= chains_.size()) return false;
    const Situation& s = situations_[state];
    at.chain = chains_[chain];
    at.state = s.state;
    at.frame = s.frame;
    at.speed = s.speed;
    return true;
}

bool Replay::push_move(const player::Move& m, operation::Sink& sink) const {
    operation::Operation o;
    if (!context(m.chain, m.state, o.at) || m.plane_u >= axis_count || m.plane_v >= axis_count) return false;
    o.at.line = m.line;
    o.at.feed = m.feed;
    o.at.pass = m.pass;
    o.others = per_axis(m.end);
    o.moved.bits = m.moved;
    o.what = what_of(m);
    sink.push(o);
    return true;
}

/// One event, or the records of one home search: one an axis. `n` goes to the event after it.
bool Replay::push_event(std::uint64_t& n, operation::Sink& sink) const {
    const player::Event e = *trajectory_.event(n);
    operation::Operation o;
    if (!context(e.chain, e.state, o.at)) return false;
    o.at.line = e.line;
    o.at.pass = e.pass;
    operation::Event event;
    event.kind = static_cast<operation::Event::Kind>(e.kind);
    event.axes.bits = e.axes;
    event.value = e.value;
    if (e.text < trajectory_.texts()) event.text = e.text + 1;
    o.what = event;
    if (e.kind == barrier_code) o.what = operation::Barrier{static_cast<operation::Barrier::Why>(e.value)};
    if (event.kind == operation::Event::Kind::home) {
        event.value = 0;
        auto next = std::optional(e);
        for (std::uint16_t last = 0; next && belongs(*next, e) && next->axes > last; next = trajectory_.event(++n)) {
            last = next->axes;
            event.axes.bits |= next->axes;
            for (Axis a : all_axes)
                if (next->axes == 1u << index(a)) o.others[a] = next->value;
        }
        o.what = event;
    } else {
        ++n;
    }
    sink.push(o);
    return true;
}

}  // namespace fagorc::tool
