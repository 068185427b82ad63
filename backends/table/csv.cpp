#include "backends/table/csv.hpp"

#include <optional>
#include <utility>

#include "backends/feed.hpp"
#include "backends/names.hpp"
#include "backends/text.hpp"
#include "ir/operation/position.hpp"

namespace fagorc::backends {
namespace {

using operation::Operation;

constexpr int decimals = 6;

/// Axes by letter: the order in which the column `axes` names them.
constexpr std::array<Axis, axis_count> by_letter = {Axis::A, Axis::B, Axis::C, Axis::U, Axis::V,
                                                    Axis::W, Axis::X, Axis::Y, Axis::Z};

std::string_view unit(program::FeedMode mode) {
    switch (mode) {
        case program::FeedMode::per_minute:
            return "mm/min";
        case program::FeedMode::per_revolution:
            return "mm/rev";
        case program::FeedMode::inverse_time:
            return "1/min";
    }
    return {};
}

class CsvWriter final : public operation::Sink {
  public:
    CsvWriter(const Job& job, Output& output, const CsvOptions& options)
        : job_(job), options_(options), out_(output), position_(job.tables, job.machine) {
        out_.text = "line,kind,x,z,cx,cz,feed,feed_unit,lead,axes";
        out_.end_line();
    }

    void push(const Operation& o) override {
        position_.enter(o);
        std::visit([&](const auto& what) { put(o, what); }, o.what);
    }
    void finish() override { out_.flush(); }

  private:
    /// The columns between the place and the axes; what is empty stays empty.
    struct Columns {
        std::optional<double> cx, cz, feed;
        std::string_view feed_unit;
        std::optional<double> lead;
    };

    void put(const Operation& o, const operation::Line& l) {
        const Columns columns = l.rapid ? Columns{} : with_feed(o);
        position_.move(o, l.end);
        row(o, l.rapid ? "rapid" : "line", columns);
        other_axes(o);
        out_.end_line();
    }

    void put(const Operation& o, const operation::Arc& a) {
        Columns columns = with_feed(o);
        position_.move(o, a.end);
        const Plane plane = position_.plane();
        PerAxis<double> centre = origin(o);
        centre[plane.u] = a.centre.u - centre[plane.u];
        centre[plane.v] = a.centre.v - centre[plane.v];
        if (plane.has(Axis::X)) columns.cx = centre[Axis::X];
        if (plane.has(Axis::Z)) columns.cz = centre[Axis::Z];
        // The row does not name the plane: the sense is that of XY, ZX, YZ, whichever axis the program has first.
        row(o, a.ccw != is_mirrored(plane) ? "ccw" : "cw", columns);
        other_axes(o);
        for (Axis axis : by_letter)
            if (plane.has(axis) && !has_column(axis)) entry({'c', lower(axis)}, centre[axis]);
        out_.end_line();
    }

    void put(const Operation& o, const operation::Thread& t) {
        position_.move(o, t.end);
        Columns columns;
        columns.lead = t.lead;
        row(o, "thread", columns);
        other_axes(o);
        if (t.angle != 0) entry("angle", t.angle);
        out_.end_line();
    }

    void put(const Operation& o, const operation::Dwell& d) {
        Columns columns;
        columns.feed = d.seconds;
        columns.feed_unit = "s";
        row(o, "dwell", columns);
        out_.end_line();
    }

    void put(const Operation& o, const operation::Event& e) {
        using Kind = operation::Event::Kind;
        if (e.kind == Kind::home) position_.home(o, e.axes);
        if (!options_.events) return;
        row(o, name(e.kind), {});
        for (Axis axis : by_letter)
            if (e.axes.has(axis)) entry({letter(axis)}, position_.axes()[axis] - origin(o)[axis]);
        if (e.text != 0)
            message(job_.texts[e.text]);
        else if (e.kind != Kind::home && e.kind != Kind::program_end)
            entry("value", e.value);
        out_.end_line();
    }

    void put(const Operation& o, const operation::Barrier& b) {
        if (!options_.events) return;
        row(o, name(b.why), {});
        out_.end_line();
    }

    /// What the coordinates count from.
    PerAxis<double> origin(const Operation& o) const {
        return options_.part_frame ? job_.tables.frames[o.at.frame].offset : PerAxis<double>{};
    }

    /// All columns at the place where the tool tip stands, up to the comma before `axes`.
    void row(const Operation& o, std::string_view kind, const Columns& columns) {
        append_whole(out_.text, o.at.line);
        (out_.text += ',') += kind;
        const PerAxis<double> from = origin(o);
        for (Axis axis : {Axis::X, Axis::Z}) number(position_.axes()[axis] - from[axis]);
        number(columns.cx);
        number(columns.cz);
        number(columns.feed);
        (out_.text += ',') += columns.feed_unit;
        number(columns.lead);
        out_.text += ',';
        first_ = true;
    }
    void number(std::optional<double> value) {
        out_.text += ',';
        if (value) append_fixed(out_.text, *value, decimals);
    }
    /// Before the position moves on.
    Columns with_feed(const Operation& o) const {
        const Feed feed = feed_of(job_, position_, o);
        Columns columns;
        columns.feed = feed.value;
        columns.feed_unit = unit(feed.unit);
        return columns;
    }

    /// The axes without a column that the move names: those of the plane and those that go along.
    void other_axes(const Operation& o) {
        const Plane plane = position_.plane();
        const PerAxis<double> from = origin(o);
        for (Axis axis : by_letter)
            if (!has_column(axis) && (plane.has(axis) || o.moved.has(axis)))
                entry({letter(axis)}, position_.axes()[axis] - from[axis]);
    }

    void entry(std::string key, double value) {
        if (!std::exchange(first_, false)) out_.text += ';';
        out_.text += key;
        out_.text += '=';
        append_fixed(out_.text, value, decimals);
    }

    /// A text as RFC 4180 quotes it; its bytes are the program's.
    void message(std::string_view text) {
        out_.text += "\"text=";
        for (char c : text) out_.text.append(c == '"' ? 2 : 1, c);
        out_.text += '"';
    }

    static bool has_column(Axis a) { return a == Axis::X || a == Axis::Z; }
    static char lower(Axis a) { return static_cast<char>(letter(a) - 'A' + 'a'); }

    Job job_;
    CsvOptions options_;
    TextWriter out_;
    operation::Position position_;
    bool first_ = true;  ///< nothing stands in the column `axes` yet
};

}  // namespace

std::unique_ptr<operation::Sink> make_csv_writer(const Job& job, Output& output, const CsvOptions& options) {
    return std::make_unique<CsvWriter>(job, output, options);
}

}  // namespace fagorc::backends
