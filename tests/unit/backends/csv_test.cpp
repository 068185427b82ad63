// The table of moves: docs/csv.md, line by line.
#include "backends/table/csv.hpp"

#include <gtest/gtest.h>

#include "tests/support/stream.hpp"

namespace fagorc::test {
namespace {

std::string csv(const Stream& made, const backends::CsvOptions& options = {}) {
    Stream s = made;
    backends::MemoryOutput output;
    s.play(*backends::make_csv_writer(s.job(), output, options));
    return std::string(output.text());
}

constexpr std::string_view header = "line,kind,x,z,cx,cz,feed,feed_unit,lead,axes\n";

TEST(Csv, OneRowOfEachKind) {
    EXPECT_EQ(csv(everything()),
              std::string(header) +
                  "3,rapid,20.000000,1.000000,,,,,,\n"
                  "4,line,20.000000,-10.000000,,,0.250000,mm/rev,,\n"
                  "5,cw,30.000000,-20.000000,20.000000,-20.000000,0.250000,mm/rev,,\n"
                  "6,ccw,30.000000,-20.000000,30.000000,-25.000000,0.250000,mm/rev,,\n"
                  "8,thread,30.000000,-40.000000,,,,,1.500000,angle=90.000000\n"
                  "9,dwell,30.000000,-40.000000,,,0.750000,s,,\n"
                  "11,line,32.000000,-40.000000,,,0.250000,mm/rev,,C=90.000000\n"
                  // In the plane XY the centre's Y has no column; the axes of the plane are named.
                  "12,ccw,42.000000,-40.000000,32.000000,,0.250000,mm/rev,,Y=10.000000;cy=10.000000\n"
                  "14,rapid,60.000000,-40.000000,,,,,,Y=0.000000\n");
}

TEST(Csv, PartFrameSubtractsTheActiveOffset) {
    Stream s;
    s.frame({{{1, 0, 100, 0, 0, 0, 0, 0, 90}}, false});
    s.next.others[Axis::C] = 180;
    s.next.moved.add(Axis::C);
    s.arc({110, 6}, {105, 6}, true);
    s.frame({{{1, 0, 100, 0, 0, 0, 0, 0, 90}}, true});  // G53: the part zero is what it is
    s.line(100, 1);
    EXPECT_EQ(csv(s, {.part_frame = true}),
              std::string(header) +
                  "1,ccw,5.000000,10.000000,5.000000,5.000000,200.000000,mm/min,,C=90.000000\n"
                  "2,line,0.000000,0.000000,,,200.000000,mm/min,,C=90.000000\n");
}

// 8055 T 5.2: F0 is MAXFEED. No axis may exceed its own, so the smallest of those that move is the feed, whatever the
// mode.
TEST(Csv, AFeedOfZeroIsTheHighestOfTheAxesThatMove) {
    Stream s;
    s.machine.axes[Axis::X].max_feed = 4000;
    s.machine.axes[Axis::Z].max_feed = 9000;
    s.machine.axes[Axis::C].max_feed = 3000;
    s.now.modal.feed = program::FeedMode::per_revolution;
    s.state();
    s.next.at.feed = 0;
    s.line(-5, 0);
    s.line(-5, 10);
    s.line(-8, 12);
    s.arc({-10, 10}, {-10, 12}, true);
    s.next.others[Axis::C] = 90;
    s.next.moved.add(Axis::C);
    s.line(-20, 10);
    EXPECT_EQ(csv(s), std::string(header) +
                          "1,line,0.000000,-5.000000,,,9000.000000,mm/min,,\n"
                          "2,line,10.000000,-5.000000,,,4000.000000,mm/min,,\n"
                          "3,line,12.000000,-8.000000,,,4000.000000,mm/min,,\n"
                          "4,ccw,10.000000,-10.000000,12.000000,-10.000000,4000.000000,mm/min,,\n"
                          "5,line,10.000000,-20.000000,,,3000.000000,mm/min,,C=90.000000\n");
}

TEST(Csv, NothingIsMinusZero) {
    Stream s;
    s.rapid(-0.0, -1e-9);
    EXPECT_EQ(csv(s), std::string(header) + "1,rapid,0.000000,0.000000,,,,,,\n");
}

TEST(Csv, EventsAreRowsOnRequest) {
    const std::string rows = csv(everything(), {.events = true});
    for (const char* row :
         {"1,tool,0.000000,0.000000,,,,,,value=1.000000\n", "2,offset,-2.000000,-30.000000,,,,,,value=1.000000\n",
          "7,message,30.000000,-20.000000,,,,,,\"text=a \"\"quoted\"\", text; \xe9\"\n",
          "10,live_stop,30.000000,-40.000000,,,,,,\n", "13,home,250.000000,-40.000000,,,,,,X=250.000000\n",
          "15,program_end,60.000000,-40.000000,,,,,,\n"})
        EXPECT_NE(rows.find(row), rows.npos) << row << rows;
}

}  // namespace
}  // namespace fagorc::test
