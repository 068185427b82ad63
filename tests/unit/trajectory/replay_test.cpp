// A trajectory file printed by a backend is what the compilation prints itself; dump and verify.
#include "tools/fagorc/trajectory/replay.hpp"

#include <gtest/gtest.h>

#include "backends/iso/iso.hpp"
#include "backends/table/csv.hpp"
#include "backends/table/json.hpp"
#include "backends/trajectory/writer.hpp"
#include "tests/support/stream.hpp"
#include "tools/fagorc/trajectory/trajectory.hpp"

namespace fagorc::test {
namespace {

using Maker = std::unique_ptr<operation::Sink> (*)(const backends::Job&, backends::Output&);

constexpr Maker csv = [](const backends::Job& job, backends::Output& output) {
    return backends::make_csv_writer(job, output, {.part_frame = false, .events = true});
};
constexpr Maker part_csv = [](const backends::Job& job, backends::Output& output) {
    return backends::make_csv_writer(job, output, {.part_frame = true, .events = false});
};
constexpr Maker iso = [](const backends::Job& job, backends::Output& output) {
    return backends::make_iso_writer(job, output, {.map = true, .events = true});
};

std::vector<std::byte> made(Stream& s, Maker maker) {
    backends::MemoryOutput output;
    s.play(*maker(s.job(), output));
    return output.bytes();
}

TEST(Replay, EveryBackendPrintsTheFileAsItPrintsTheCompilation) {
    for (const Stream& stream : {everything(), Stream{}}) {
        Stream s = stream;
        const auto file = made(s, backends::make_trajectory_writer);
        player::Trajectory trajectory;
        ASSERT_EQ(trajectory.open(file), player::Status::ok);
        const tool::Replay replay(trajectory);
        for (const Maker maker : {csv, part_csv, iso, Maker{backends::make_json_writer}}) {
            backends::MemoryOutput output;
            replay.run(*maker(replay.job(s.findings), output));
            const auto expected = made(s, maker);
            EXPECT_EQ(output.text(), std::string_view(reinterpret_cast<const char*>(expected.data()), expected.size()));
        }
    }
}

TEST(Dump, HasALineForEveryRecord) {
    Stream s = everything();
    const auto file = made(s, backends::make_trajectory_writer);
    backends::MemoryOutput output;
    EXPECT_TRUE(tool::dump_trajectory("x.ftj", file, output, s.findings));
    for (const char* line :
         {"\nmove 2 cw X30 Z-20 centre Z-20 X20 feed 0.25 line 5 pass 0 chain 0 state 2\n",
          "\nevent 2 before 4 message value 0 axes - text 0 line 7 pass 3 chain 1 state 2\n",
          "\nchain 1 program 1 caller 0 line 7\n", "\n  |a \"quoted\", text; \u00e9\n", "\nsource 0 size 30\n"})
        EXPECT_NE(output.text().find(line), std::string_view::npos) << line << output.text();
}

TEST(Verify, NamesWhatIsWrong) {
    Stream s = everything();
    auto file = made(s, backends::make_trajectory_writer);
    EXPECT_TRUE(tool::verify_trajectory("x.ftj", file, s.findings));
    file.pop_back();
    EXPECT_FALSE(tool::verify_trajectory("x.ftj", file, s.findings));
    file.resize(10);
    EXPECT_FALSE(tool::verify_trajectory("x.ftj", file, s.findings));
    file[0] = std::byte{0};
    EXPECT_FALSE(tool::verify_trajectory("x.ftj", file, s.findings));
    ASSERT_EQ(s.findings.list.size(), 3u);
    EXPECT_EQ(s.findings.list[0].id, diag::Id::trajectory_truncated);
    EXPECT_EQ(s.findings.list[1].id, diag::Id::trajectory_truncated);
    EXPECT_EQ(s.findings.list[2].id, diag::Id::trajectory_bad_magic);
}

}  // namespace
}  // namespace fagorc::test
