// Neutral ISO: the words of each kind of move. That a reader makes the same moves of them is the oracle test's.
#include "backends/iso/iso.hpp"

#include <gtest/gtest.h>

#include "tests/support/stream.hpp"

namespace fagorc::test {
namespace {

/// The blocks after the first two lines (producer, preparatory block), before M2.
std::string iso(Stream& s, const backends::IsoOptions& options = {}) {
    backends::MemoryOutput output;
    s.play(*backends::make_iso_writer(s.job(), output, options));
    const std::string text(output.text());
    EXPECT_EQ(text.substr(0, 11), "(test 1.0)\n");
    const std::size_t begin = text.find('\n', 11) + 1, end = text.rfind('N');
    EXPECT_EQ(text.substr(text.find(' ', end) + 1), "M2\n");
    return text.substr(begin, end - begin);
}

TEST(Iso, LinesNameTheAxesThatChange) {
    Stream s;
    s.now.turn = operation::SpindleTurn::clockwise;
    s.state();
    s.rapid(2, 10);
    s.line(-5, 10);
    s.line(-5, 12.5);
    EXPECT_EQ(iso(s),
              "N2 S1000 M3\n"
              "N3 G0 X10 Z2\n"
              "N4 G1 Z-5 F200\n"
              "N5 G1 X12.5\n");
}

TEST(Iso, ArcsCountTheirCentreFromTheStart) {
    Stream s;
    s.next.at.speed = 0;
    s.line(0, 10);
    s.arc({-5, 15}, {-5, 10}, false);        // from (0, 10) about (-5, 10): I0 K-5
    s.arc({-5, 15}, {-10, 15}, true, true);  // a whole turn
    EXPECT_EQ(iso(s),
              "N2 G1 X10 Z0 F200\n"
              "N3 G2 X15 Z-5 I0 K-5\n"
              "N4 G3 X15 Z-5 I0 K-5\n");
}

TEST(Iso, TheCentreFitsTheRoundedStart) {
    // The start prints as 0.333333; the centre is counted from there, not from 1/3.
    Stream s;
    s.next.at.speed = 0;
    s.line(0, 1.0 / 3);
    s.arc({1.0 / 3, 0}, {0, 0}, false);
    EXPECT_EQ(iso(s),
              "N2 G1 X0.333333 Z0 F200\n"
              "N3 G2 X0 Z0.333333 I-0.333333 K0\n");
}

TEST(Iso, AnArcShorterThanAPrintedDigitIsNoFullCircle) {
    Stream s;
    s.next.at.speed = 0;
    s.line(0, 10);
    s.arc({-1e-8, 10}, {0, 5}, true);  // a hundred-millionth of a millimetre
    s.line(3, 10);
    EXPECT_EQ(iso(s),
              "N2 G1 X10 Z0 F200\n"
              "N3 G1 Z3\n");
}

TEST(Iso, FeedAndSpindleModes) {
    Stream s;
    s.next.at.speed = 150;
    s.now.modal.feed = program::FeedMode::per_revolution;
    s.now.modal.speed = program::SpeedMode::constant_surface;
    s.now.speed_limit = 2500;
    s.now.turn = operation::SpindleTurn::counter_clockwise;
    s.state();
    s.next.at.feed = 0.2;
    s.line(1, 1);
    s.now.modal.feed = program::FeedMode::per_minute;
    s.now.modal.speed = program::SpeedMode::rpm;
    s.state();
    s.next.at.speed = 800;
    s.next.at.feed = 120;
    s.line(2, 1);
    s.next.at.feed = 0;  // the highest: the axes' own 10000
    s.line(3, 1);
    EXPECT_EQ(iso(s),
              "N2 G96 D2500 S150 M4\n"
              "N3 G95 G1 X1 Z1 F0.2\n"
              "N4 G97 S800\n"
              "N5 G94 G1 Z2 F120\n"
              "N6 G1 Z3 F10000\n");
}

TEST(Iso, ThreadsAndDwells) {
    Stream s;
    s.now.turn = operation::SpindleTurn::clockwise;
    s.state();
    s.rapid(0, 10);
    s.add(operation::Thread{{-20, 10}, 1.5, 0});
    s.add(operation::Dwell{0.25});
    EXPECT_EQ(iso(s),
              "N2 S1000 M3\n"
              "N3 G0 X10 Z0\n"
              "N4 G33 Z-20 K1.5\n"
              "N5 G4 P0.25\n");
}

TEST(Iso, OtherPlanesAndTheirMirrorImages) {
    Stream s;
    s.next.at.speed = 0;
    s.now.modal.plane = plane_g17;
    s.state();
    s.line(10, 0);
    s.arc({0, 10}, {0, 0}, true);
    s.now.modal.plane = {Axis::Y, Axis::X};  // the same plane seen from behind
    s.state();
    s.arc({0, 10}, {0, 0}, true);  // u = Y: from (10, 0) to (0, 10), counter-clockwise from Y to X
    EXPECT_EQ(iso(s),
              "N2 G1 X10 Y0 F200\n"
              "N3 G17 G3 X0 Y10 I-10 J0\n"
              "N4 G2 X10 Y0 I0 J-10\n");
}

TEST(Iso, EventsAreCommentsOrFunctions) {
    using Kind = operation::Event::Kind;
    Stream s;
    s.event(Kind::tool, 3);
    s.event(Kind::misc, 8);
    s.event(Kind::misc, 41);
    s.message("a (b) \xe9");
    EXPECT_EQ(iso(s), "(T3)\n(M8)\n(M41)\n(message: a [b] ?)\n");
    EXPECT_EQ(iso(s, {.events = true}), "N2 T3 M6\nN3 M8\n(M41)\n(message: a [b] ?)\n");
}

TEST(Iso, TheMapNamesLinesAndLabels) {
    Stream s;
    s.next.at.speed = 0;
    s.next.at.line = 16;
    s.rapid(1, 1);
    s.programs.list.push_back({"lib/000012.PIT", ""});
    s.chain({diag::FileId{1}, s.next.at.chain, 17});
    s.rapid(2, 1);
    s.programs.labels[18] = 30;
    EXPECT_EQ(iso(s, {.map = true}), "N2 G0 X1 Z1 (line 17)\nN3 G0 Z2 (000012.PIT line 18 N30)\n");
}

TEST(Iso, WhatItCannotSayIsReportedOnce) {
    Stream s;
    s.add(operation::Thread{{-20, 10}, 1.5, 0});  // the spindle stands
    s.add(operation::Thread{{-30, 10}, 1.5, 0});
    s.now.turn = operation::SpindleTurn::clockwise;
    s.state();
    s.add(operation::Thread{{-40, 10}, 1.5, 180});
    s.now.modal.plane = {Axis::Z, Axis::C};
    s.state();
    s.arc({-50, 20}, {-45, 15}, true);
    iso(s);
    ASSERT_EQ(s.findings.list.size(), 3u);
    for (const auto& d : s.findings.list) EXPECT_EQ(d.id, diag::Id::output_cannot_say);
    EXPECT_EQ(s.findings.list[0].place.line, 1u);
    EXPECT_EQ(s.findings.list[0].arguments[1].in(Language::english), "a thread while the spindle stands");
}

TEST(Iso, NoBlockIsLongerThanItsReaderTakes) {
    Stream s;
    s.programs.list[0].name = std::string(200, 'n');
    s.message(std::string(1000, 'm'));
    for (Axis a : all_axes) {
        s.next.others[a] = -12345.123456;
        s.next.moved.add(a);
    }
    s.chain({diag::FileId{0}, s.next.at.chain, 17});
    s.next.at.line = 4'000'000'000;
    s.next.at.feed = 12345.123456;
    s.now.modal.feed = program::FeedMode::per_revolution;
    s.state();
    s.arc({-12345.123456, -12345.123456}, {-12345.123456 / 2, -12345.123456 / 2}, true);
    const std::string text = iso(s, {.map = true});
    for (std::size_t at = 0, end; at < text.size(); at = end + 1) {
        end = text.find('\n', at);
        EXPECT_LE(end - at, 255u) << text.substr(at, end - at);
    }
    EXPECT_TRUE(s.findings.list.empty());
}

}  // namespace
}  // namespace fagorc::test
