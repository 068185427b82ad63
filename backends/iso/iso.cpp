#include "backends/iso/iso.hpp"

#include <algorithm>
#include <cmath>

#include "backends/feed.hpp"
#include "backends/iso/refusal.hpp"
#include "backends/iso/spindle.hpp"
#include "backends/names.hpp"
#include "backends/text.hpp"
#include "ir/operation/position.hpp"

namespace fagorc::backends {
namespace {

using namespace iso;
using operation::Operation;

constexpr int decimals = 6;

/// A coordinate as it is printed: what the reader of the block works with.
double printed(double value) {
    constexpr double scale = 1e6;
    const double scaled = std::round(value * scale);
    return scaled == 0 ? 0 : scaled / scale;
}

/// Largest difference of the radii at both ends that rounding to the printed decimals explains, mm.
constexpr double radius_tolerance = 1e-4;
/// Blocks of RS-274 have at most 255 characters; the longest block of numbers has about 200.
constexpr std::size_t longest_comment = 50;

class IsoWriter final : public operation::Sink {
  public:
    IsoWriter(const Job& job, Output& output, const IsoOptions& options)
        : job_(job), options_(options), out_(output), position_(job.tables, job.machine) {
        comment(job.producer);
        block("G21 G90 G91.1 G8 G18 G40 G49 G94 G97");
        std::transform(job.machine.start.begin(), job.machine.start.end(), at_.begin(), printed);
    }

    void push(const Operation& o) override {
        position_.enter(o);
        std::visit([&](const auto& what) { put(o, what); }, o.what);
    }
    void finish() override {
        block("M2");
        out_.flush();
    }

  private:
    void put(const Operation& o, const operation::Line& l) {
        const Feed f = feed_of(job_, position_, o);
        arrive(o, l.end);
        const std::string words = axis_words(o, false);
        if (words.empty()) return;
        if (l.rapid)
            motion(o, "G0" + words);
        else
            motion(o, feed_mode(o, f) + "G1" + words + feed(f));
    }

    void put(const Operation& o, const operation::Arc& a) {
        const Plane plane = position_.plane();
        const Point start{at_[plane.u], at_[plane.v]};
        const Feed f = feed_of(job_, position_, o);
        arrive(o, a.end);
        Point end = a.end;
        // The words of an arc that closes are those of its start; a turn that rounding closes is none.
        if (a.full || (printed(end.u) == start.u && printed(end.v) == start.v)) {
            if (!a.full && swept_angle(start, end, a.centre, a.ccw, false) < std::numbers::pi) return;
            end = start;
        }
        const char* code = code_of(plane);
        if (!code) return refuse(o, Refusal::arc_plane);
        if (std::abs(distance(start, a.centre) - distance(end, a.centre)) > radius_tolerance)
            return refuse(o, Refusal::arc_start);
        target_[plane.u] = printed(end.u);
        target_[plane.v] = printed(end.v);
        std::string words = feed_mode(o, f);
        if (code != plane_code_) (words += plane_code_ = code) += ' ';
        words += a.ccw != is_mirrored(plane) ? "G3" : "G2";
        words += axis_words(o, true);
        for (Axis axis : {std::min(plane.u, plane.v), std::max(plane.u, plane.v)})
            append_word(words, centre_letter(axis), axis == plane.u ? a.centre.u - start.u : a.centre.v - start.v);
        motion(o, words + feed(f));
    }

    void put(const Operation& o, const operation::Thread& t) {
        arrive(o, t.end);
        const std::string words = axis_words(o, false);
        const operation::State& s = state(o);
        if (t.angle != 0) return refuse(o, Refusal::thread_angle);
        if (s.turn != operation::SpindleTurn::clockwise && s.turn != operation::SpindleTurn::counter_clockwise)
            return refuse(o, Refusal::thread_without_spindle);
        if (s.modal.spindle != program::Spindle::main) return refuse(o, Refusal::second_spindle);
        if (words.empty()) return;
        std::string text = "G33" + words;
        append_word(text, 'K', t.lead);
        motion(o, text);
    }

    void put(const Operation& o, const operation::Dwell& d) {
        std::string text = "G4";
        append_word(text, 'P', d.seconds);
        motion(o, text);
    }

    void put(const Operation& o, const operation::Event& e);
    void put(const Operation&, const operation::Barrier&) {}

    /// The code of the plane that has these two axes; null where ISO has none.
    static const char* code_of(Plane plane) {
        static constexpr std::array<std::pair<Plane, const char*>, 3> planes = {
            {{plane_g17, "G17"}, {plane_g18, "G18"}, {plane_g19, "G19"}}};
        for (const auto& [known, code] : planes)
            if (known.has(plane.u) && known.has(plane.v)) return code;
        return nullptr;
    }

    void arrive(const Operation& o, Point end) {
        position_.move(o, end);
        std::transform(position_.axes().begin(), position_.axes().end(), target_.begin(), printed);
    }

    /// The axes of the move whose printed coordinate changes, or of which nothing has been said yet; of an arc those of
    /// the plane always. The reader of the block stands there afterwards.
    std::string axis_words(const Operation& o, bool arc) {
        std::string words;
        for (Axis a : all_axes) {
            const bool in_plane = position_.plane().has(a);
            if (!in_plane && !o.moved.has(a)) continue;
            if ((arc && in_plane) || !said_.has(a) || target_[a] != at_[a]) append_word(words, letter(a), target_[a]);
            at_[a] = target_[a];
            said_.add(a);
        }
        return words;
    }

    static void append_word(std::string& out, char address, double value) {
        (out += ' ') += address;
        append_trimmed(out, value, decimals);
    }

    const operation::State& state(const Operation& o) const { return job_.tables.states[o.at.state]; }

    /// The feed mode when it is a new one, with the blank after it. F of the old mode does not hold in the new one.
    std::string feed_mode(const Operation& o, const Feed& f) {
        using program::FeedMode;
        const FeedMode mode = f.unit;
        if (mode == FeedMode::per_revolution) {
            if (o.at.speed == 0) refuse(o, Refusal::no_speed);
            if (state(o).modal.spindle != program::Spindle::main) refuse(o, Refusal::second_spindle);
        }
        if (mode == feed_mode_) return {};
        feed_mode_ = mode;
        feed_ = 0;
        return mode == FeedMode::per_minute ? "G94 " : mode == FeedMode::per_revolution ? "G95 " : "G93 ";
    }
    std::string feed(const Feed& f) {
        if (f.value == feed_ && feed_mode_ != program::FeedMode::inverse_time) return {};
        feed_ = f.value;
        std::string word;
        append_word(word, 'F', f.value);
        return word;
    }

    void motion(const Operation& o, const std::string& words) {
        if (const std::string spindle = spindle_.words(state(o), o.at.speed); !spindle.empty()) block(spindle);
        number();
        out_.text += words;
        if (options_.map) append_place(o);
        out_.end_line();
    }
    void number() {
        append_whole(out_.text += 'N', ++blocks_);
        out_.text += ' ';
    }
    void block(std::string_view words) {
        number();
        out_.text += words;
        out_.end_line();
    }
    void comment(std::string_view text) {
        append_comment(text);
        out_.end_line();
    }
    void append_comment(std::string_view text) {
        out_.text += '(';
        for (char c : text.substr(0, longest_comment)) {
            const bool plain = c >= ' ' && c <= '~' && c != '(' && c != ')';
            out_.text += plain ? c : c == '(' ? '[' : c == ')' ? ']' : '?';
        }
        out_.text += ')';
    }
    void append_place(const Operation& o) {
        const operation::Chain& chain = job_.tables.chains[o.at.chain];
        std::string text = "line ";
        append_whole(text, o.at.line);
        if (const auto label = job_.programs.label(o.at)) append_whole(text += " N", *label);
        if (chain.caller_line != 0) text.insert(0, std::string(base_name(job_.programs.name(chain.program))) + ' ');
        out_.text += ' ';
        append_comment(text);
    }

    void refuse(const Operation& o, Refusal what) {
        const auto n = static_cast<std::size_t>(what);
        if (std::exchange(refused_[n], true)) return;
        static constexpr Text self{"neutral ISO", "l'ISO neutre", "el ISO neutro"};
        job_.diagnostics.report(diag::Id::output_cannot_say, job_.programs.place(o.at), self, refusal_texts[n]);
    }

    Job job_;
    IsoOptions options_;
    TextWriter out_;
    operation::Position position_;
    Spindle spindle_;
    AxisSet said_;                     ///< axes that have had a word
    PerAxis<double> at_{}, target_{};  ///< printed coordinates: where the reader stands, where it goes
    std::string plane_code_ = "G18";
    program::FeedMode feed_mode_ = program::FeedMode::per_minute;
    double feed_ = 0;
    std::uint64_t blocks_ = 0;
    std::array<bool, refusal_count> refused_{};
};

void IsoWriter::put(const Operation& o, const operation::Event& e) {
    using Kind = operation::Event::Kind;
    std::string text;
    bool function = false;
    switch (e.kind) {
        case Kind::misc: {
            append_trimmed(text = "M", e.value, 0);
            function = e.value == 0 || e.value == 1 || (e.value >= 7 && e.value <= 9);
            break;
        }
        case Kind::tool:
            append_trimmed(text = "T", e.value, 0);
            if (options_.events) text += " M6";
            function = true;
            break;
        case Kind::offset:
            append_trimmed(text = "D", e.value, 0);
            break;
        case Kind::home:
            position_.home(o, e.axes);
            text = "home";
            for (Axis a : all_axes)
                if (e.axes.has(a)) (text += ' ') += letter(a);
            break;
        case Kind::message:
            text = "message: " + job_.texts[e.text];
            break;
        case Kind::program_end:
            return;
        case Kind::spindle_angle:
        case Kind::live_tool:
        case Kind::error:
        case Kind::graphic_zone:
            append_trimmed((text = name(e.kind)) += ' ', e.value, decimals);
            break;
    }
    if (options_.events && function)
        block(text);
    else
        comment(text);
}

}  // namespace

std::unique_ptr<operation::Sink> make_iso_writer(const Job& job, Output& output, const IsoOptions& options) {
    return std::make_unique<IsoWriter>(job, output, options);
}

}  // namespace fagorc::backends
