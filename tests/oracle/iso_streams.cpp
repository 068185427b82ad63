// Writes streams of operations as neutral ISO and as a table of moves, for rs274_moves.py to compare:
// `iso_streams NAME FOLDER` makes FOLDER/NAME.ngc and FOLDER/NAME.csv. Streams are random but always the same.
#include <cmath>
#include <cstdio>
#include <functional>
#include <map>
#include <random>
#include <string>

#include "backends/iso/iso.hpp"
#include "backends/table/csv.hpp"
#include "tests/support/stream.hpp"

namespace fagorc::test {
namespace {

/// Numbers that the standard fixes for all machines: distributions are not, so ranges are made here.
class Random {
  public:
    double between(double least, double most) {
        return least + (most - least) * (static_cast<double>(engine_()) / 4294967296.0);
    }
    /// With as many decimals as a program has.
    double programmed(double least, double most) { return std::round(between(least, most) * 1e4) / 1e4; }
    bool coin() { return engine_() & 1; }

  private:
    std::mt19937 engine_{20240229};
};

void set(Stream& s, Plane plane, operation::SpindleTurn turn = operation::SpindleTurn::clockwise) {
    s.now.modal.plane = plane;
    s.now.turn = turn;
    s.state();
}

void lines(Stream& s, Random& random) {
    for (int i = 0; i < 400; ++i) {
        s.next.at.feed = random.programmed(1, 5000);
        const double u = random.between(-500, 500), v = random.between(-500, 500);
        if (random.coin())
            s.rapid(u, v);
        else
            s.line(u, v);
    }
}

/// Arcs from where the last one ended, of all sizes: radii from 0.01 mm to a kilometre, any angle, whole turns.
void arcs(Stream& s, Random& random, Plane plane) {
    set(s, plane);
    Point at{-20, 30};
    s.rapid(at.u, at.v);
    for (int i = 0; i < 400; ++i) {
        const double radius = std::pow(10.0, random.between(-2, i % 10 == 0 ? 6 : 2));
        const double from = random.between(0, 360);
        const bool ccw = random.coin(), full = i % 13 == 0;
        const Point centre = at + radius * direction(from);
        // Chords of big arcs stay on the machine: the swept angle shrinks with the radius.
        const double swept = radius > 100 ? degrees(random.between(1, 100) / radius) : random.between(1, 359);
        const Point end = full ? at : centre + radius * direction(from + 180 + (ccw ? swept : -swept));
        s.arc(end, centre, ccw, full);
        at = end;
    }
}

void threads(Stream& s, Random& random) {
    set(s, plane_g18);
    double z = 5, x = 20;
    for (int i = 0; i < 60; ++i) {
        s.rapid(z, x);
        z = random.programmed(-100, 0);
        x = random.programmed(1, 40);
        s.add(operation::Thread{{z, x}, random.programmed(0.2, 6), 0});
        s.add(operation::Dwell{random.programmed(0.01, 3)});
    }
}

/// Not U V W: the stand-alone interpreter has a machine of six axes.
void other_axes(Stream& s, Random& random) {
    set(s, plane_g18);
    for (int i = 0; i < 100; ++i) {
        s.next.moved = {};
        for (Axis a : {Axis::Y, Axis::A, Axis::B, Axis::C})
            if (random.coin()) {
                s.next.moved.add(a);
                s.next.others[a] = random.programmed(-180, 180);
            }
        s.line(random.between(-100, 100), random.between(0, 50));
    }
}

/// Feed and spindle modes in turn, with moves in each.
void modes(Stream& s, Random& random) {
    for (int i = 0; i < 200; ++i) {
        s.now.modal.feed = random.coin() ? program::FeedMode::per_revolution : program::FeedMode::per_minute;
        s.now.modal.speed = random.coin() ? program::SpeedMode::constant_surface : program::SpeedMode::rpm;
        s.now.turn = random.coin() ? operation::SpindleTurn::clockwise : operation::SpindleTurn::counter_clockwise;
        s.now.speed_limit = random.coin() ? 2500 : 0;
        s.next.at.speed = random.programmed(50, 3000);
        s.next.at.feed = i % 7 == 0 ? 0 : random.programmed(0.01, 2000);
        s.state();
        s.line(random.between(-100, 100), random.between(0, 50));
    }
}

using Maker = std::function<void(Stream&, Random&)>;

const std::map<std::string, Maker> streams = {
    {"lines", lines},
    {"arcs_zx", [](Stream& s, Random& r) { arcs(s, r, plane_g18); }},
    {"arcs_xy", [](Stream& s, Random& r) { arcs(s, r, plane_g17); }},
    {"arcs_yz", [](Stream& s, Random& r) { arcs(s, r, plane_g19); }},
    {"threads", threads},
    {"other_axes", other_axes},
    {"modes", modes},
};

bool save(const std::string& path, const backends::MemoryOutput& made) {
    const auto file = backends::open_file(path);
    return file->write(made.text()) && file->finish();
}

int make(const std::string& name, const std::string& folder) {
    const auto at = streams.find(name);
    if (at == streams.end()) return 2;
    Stream s;
    Random random;
    at->second(s, random);
    backends::MemoryOutput iso, csv;
    s.play(*backends::make_iso_writer(s.job(), iso, {.map = true, .events = false}));
    s.play(*backends::make_csv_writer(s.job(), csv, {}));
    for (const diag::Diagnostic& d : s.findings.list)
        std::fprintf(stderr, "%s\n", std::string(d.arguments[1].in(Language::english)).c_str());
    const bool saved = save(folder + '/' + name + ".ngc", iso) && save(folder + '/' + name + ".csv", csv);
    return saved && s.findings.list.empty() ? 0 : 1;
}

}  // namespace
}  // namespace fagorc::test

int main(int count, char** arguments) {
    if (count != 3) return 2;
    return fagorc::test::make(arguments[1], arguments[2]);
}
