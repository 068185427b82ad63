#include "backends/table/json.hpp"

#include "backends/feed.hpp"
#include "backends/names.hpp"
#include "backends/numbering.hpp"
#include "backends/table/json_text.hpp"
#include "backends/text.hpp"
#include "ir/operation/position.hpp"

namespace fagorc::backends {
namespace {

using operation::Operation;

class JsonWriter final : public NumberingSink {
  public:
    JsonWriter(const Job& job, Output& output) : NumberingSink(job), out_(output), position_(job.tables, job.machine) {
        out_.text += json_header(job);
        out_.end_line();
    }

    void push(const Operation& o) override {
        position_.enter(o);
        std::visit([&](const auto& what) { put(o, what); }, o.what);
    }

    void finish() override {
        out_.text += "{\"type\":\"end\"";
        whole("moves", moves_);
        whole("events", events_);
        truth("completed", completed_);
        end_object();
        out_.flush();
    }

  private:
    void put(const Operation& o, const operation::Line& l) {
        const Feed f = feed_of(job(), position_, o);
        begin_move(o, l.rapid ? "rapid" : "line", l.end);
        if (!l.rapid) feed(o, f);
        end_move(o);
    }
    void put(const Operation& o, const operation::Arc& a) {
        const Feed f = feed_of(job(), position_, o);
        begin_move(o, a.ccw ? "ccw" : "cw", a.end);
        PerAxis<double> centre{};
        const Plane plane = position_.plane();
        centre[plane.u] = a.centre.u;
        centre[plane.v] = a.centre.v;
        AxisSet axes;
        axes.add(plane.u);
        axes.add(plane.v);
        coordinates("centre", axes, centre);
        truth("full", a.full);
        feed(o, f);
        end_move(o);
    }
    void put(const Operation& o, const operation::Thread& t) {
        begin_move(o, "thread", t.end);
        number("lead", t.lead);
        number("angle", t.angle);
        end_move(o);
    }
    void put(const Operation& o, const operation::Dwell& d) {
        begin_move(o, "dwell", position_.point());
        number("seconds", d.seconds);
        end_move(o);
    }
    void put(const Operation& o, const operation::Event& e) {
        using Kind = operation::Event::Kind;
        if (e.kind == Kind::home) position_.home(o, e.axes);
        completed_ = completed_ || e.kind == Kind::program_end;
        const std::uint32_t text = text_number(e.text);
        begin_event(o, name(e.kind));
        if (text != no_number) (out_.text += ",\"text\":") += json_string(job().texts[e.text]);
        if (!e.axes.empty()) coordinates("axes", e.axes, position_.axes());
        number("value", e.value);
        origin(o);
        end_object();
    }
    void put(const Operation& o, const operation::Barrier& b) {
        begin_event(o, name(b.why));
        origin(o);
        end_object();
    }

    void begin_move(const Operation& o, std::string_view kind, Point end) {
        prepare(o);
        position_.move(o, end);
        out_.text += "{\"type\":\"move\"";
        whole("move", moves_++);
        string("kind", kind);
        AxisSet axes = o.moved;
        for (Axis a : {Axis::X, Axis::Z, position_.plane().u, position_.plane().v}) axes.add(a);
        coordinates("end", axes, position_.axes());
    }
    void end_move(const Operation& o) {
        origin(o);
        end_object();
    }
    /// F0 has a unit of its own; the unit of the others stands in the state.
    void feed(const Operation& o, const Feed& f) {
        number("feed", f.value);
        if (o.at.feed == 0) string("feed_unit", "mm/min");
    }
    void begin_event(const Operation& o, std::string_view kind) {
        prepare(o);
        ++events_;
        out_.text += "{\"type\":\"event\"";
        whole("before", moves_);
        string("kind", kind);
    }

    /// The lines of a new chain and state come before the line that refers to them.
    void prepare(const Operation& o) {
        chain_ = chain_number(o.at.chain);
        state_ = state_number(o.at);
    }
    void origin(const Operation& o) {
        whole("line", o.at.line);
        whole("pass", o.at.pass);
        whole("chain", chain_);
        whole("state", state_);
    }

    void new_program(std::uint32_t n, diag::FileId file) override {
        out_.text += "{\"type\":\"program\"";
        whole("program", n);
        (out_.text += ",\"name\":") += json_string(base_name(job().programs.name(file)));
        end_object();
    }
    void new_chain(std::uint32_t n, std::uint32_t program, std::uint32_t caller, std::uint32_t line) override {
        out_.text += "{\"type\":\"chain\"";
        whole("chain", n);
        if (program != no_number) whole("program", program);
        if (caller != no_number) {
            whole("caller", caller);
            whole("line", line);
        }
        end_object();
    }
    void new_state(std::uint32_t n, const Situation& situation) override {
        out_.text += json_state(job(), n, situation);
        out_.end_line();
    }
    void new_text(std::uint32_t, std::string_view) override {}  // stands in its event

    void key(std::string_view name) { ((out_.text += ",\"") += name) += "\":"; }
    void number(std::string_view name, double value) {
        key(name);
        append_shortest(out_.text, value);
    }
    void whole(std::string_view name, std::uint64_t value) {
        key(name);
        append_whole(out_.text, value);
    }
    void truth(std::string_view name, bool value) {
        key(name);
        out_.text += value ? "true" : "false";
    }
    void string(std::string_view name, std::string_view plain) {
        key(name);
        ((out_.text += '"') += plain) += '"';
    }
    void coordinates(std::string_view name, AxisSet axes, const PerAxis<double>& values) {
        key(name);
        char before = '{';
        for (Axis a : all_axes) {
            if (!axes.has(a)) continue;
            ((out_.text += before) += '"') += letter(a);
            out_.text += "\":";
            append_shortest(out_.text, values[a]);
            before = ',';
        }
        out_.text += '}';
    }
    void end_object() {
        out_.text += '}';
        out_.end_line();
    }

    TextWriter out_;
    operation::Position position_;
    std::uint64_t moves_ = 0, events_ = 0;
    std::uint32_t chain_ = 0, state_ = 0;
    bool completed_ = false;
};

}  // namespace

std::unique_ptr<operation::Sink> make_json_writer(const Job& job, Output& output) {
    return std::make_unique<JsonWriter>(job, output);
}

}  // namespace fagorc::backends
