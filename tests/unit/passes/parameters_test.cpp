// Levels and ranges of the arithmetic parameters (8055 T 11.2.1), and the watch for endless loops.
#include "passes/execute/parameters.hpp"

#include <gtest/gtest.h>

#include "passes/execute/loops.hpp"

namespace fagorc::passes {
namespace {

using Scope = control::ParameterRange::Scope;

constexpr control::ParameterRange ranges[] = {
    {0, 25, Scope::local}, {100, 299, Scope::global}, {1000, 1255, Scope::user}, {2000, 2255, Scope::oem}};

control::Dialect dialect() {
    control::Dialect d{};
    d.parameters = ranges;
    return d;
}

TEST(Parameters, ExistInTheirRangesOnly) {
    const auto d = dialect();
    Parameters p(d, {});
    for (std::uint32_t n : {0u, 25u, 100u, 299u, 1000u, 1255u}) EXPECT_NE(p.find(n), nullptr) << n;
    for (std::uint32_t n : {26u, 99u, 300u, 999u, 1256u, 1999u, 2256u, 4294967295u}) EXPECT_EQ(p.find(n), nullptr) << n;
}

TEST(Parameters, OfTheMachineBuilderNeedTheirAttribute) {
    const auto d = dialect();
    Parameters p(d, {{2000, 7}});
    EXPECT_EQ(p.find(2000), nullptr);
    EXPECT_TRUE(p.is_oem(2255));
    EXPECT_FALSE(p.is_oem(299));
    p.allow_oem(true);
    ASSERT_NE(p.find(2000), nullptr);
    EXPECT_EQ(*p.find(2000), 7);
}

TEST(Parameters, ALevelStartsAtZeroAndGivesTheCallersBack) {
    const auto d = dialect();
    Parameters p(d, {{100, 1.5}});
    *p.find(3) = 4;
    for (int level = 1; level <= 6; ++level) {
        ASSERT_TRUE(p.enter()) << level;
        EXPECT_EQ(*p.find(3), 0);
        *p.find(3) = level;
        EXPECT_EQ(*p.find(100), 1.5);
    }
    EXPECT_FALSE(p.enter());   // 6 levels besides that of the main program
    for (int level = 6; level >= 1; --level) {
        EXPECT_EQ(*p.find(3), level);
        p.leave();
    }
    EXPECT_EQ(*p.find(3), 4);
}

TEST(LoopWatch, SeesTheSameJumpWithNothingChanged) {
    LoopWatch w;
    const auto file = static_cast<diag::FileId>(0);
    EXPECT_FALSE(w.endless(file, 10, 1));
    EXPECT_FALSE(w.endless(file, 10, 2));   // something changed
    EXPECT_TRUE(w.endless(file, 10, 2));
}

TEST(LoopWatch, SeesALoopOfSeveralJumpsBehindOthers) {
    LoopWatch w;
    const auto file = static_cast<diag::FileId>(0);
    EXPECT_FALSE(w.endless(file, 500, 0));   // the way into the loop, never taken again
    int jumps = 0;
    for (bool found = false; !found; ++jumps) found = w.endless(file, 10 + 10 * (jumps % 3), 0);
    EXPECT_LE(jumps, 10);
}

}  // namespace
}  // namespace fagorc::passes
