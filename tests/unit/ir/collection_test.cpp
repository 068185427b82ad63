// The sinks: a finding is passed on once, counted, and kept in the order of discovery.
#include "ir/diag/collection.hpp"

#include <gtest/gtest.h>

namespace fagorc::diag {
namespace {

Place at(std::uint32_t line, std::uint32_t column = 1) {
    return {FileId{0}, line, column, column + 1, line * 10};
}

TEST(Once, PassesARepeatedFindingOnce) {
    Collection kept;
    Once once(kept);
    for (int pass = 0; pass < 1000; ++pass) once.report(Id::division_by_zero, at(3));
    ASSERT_EQ(kept.list().size(), 1u);
    EXPECT_EQ(once.counts().errors(), 1u);
}

TEST(Once, RemembersTheLastOnesOfMillions) {
    Collection kept;
    Once once(kept);
    for (std::uint32_t line = 1; line <= 300'000; ++line) once.report(Id::division_by_zero, at(line));
    EXPECT_EQ(kept.list().size(), 300'000u);
    for (std::uint32_t line = 300'000 - 65'000; line <= 300'000; ++line) once.report(Id::division_by_zero, at(line));
    EXPECT_EQ(kept.list().size(), 300'000u);
}

TEST(Once, TellsPlacesAndCodesApart) {
    Collection kept;
    Once once(kept);
    once.report(Id::division_by_zero, at(3));
    once.report(Id::division_by_zero, at(3, 5));
    once.report(Id::division_by_zero, at(4));
    once.report(Id::result_not_a_number, at(3));
    EXPECT_EQ(kept.list().size(), 4u);
}

TEST(Once, PassesEveryFindingThatHasNoPlace) {
    Collection kept;
    Once once(kept);
    once.report(Id::cannot_read, Place{}, "a", "b");
    once.report(Id::cannot_read, Place{}, "c", "b");
    EXPECT_EQ(kept.list().size(), 2u);
}

TEST(Once, KeepsTheOrderOfDiscovery) {
    Collection kept;
    Once once(kept);
    for (std::uint32_t line : {9u, 2u, 5u}) once.report(Id::division_by_zero, at(line));
    EXPECT_EQ(kept.list()[0].place.line, 9u);
    EXPECT_EQ(kept.list()[1].place.line, 2u);
    EXPECT_EQ(kept.list()[2].place.line, 5u);
}

TEST(Once, CountsBySeverityAndBeyondTheLimit) {
    Collection kept;
    Once once(kept, 2);
    once.report(Id::no_program_end, at(1));
    once.report(Id::division_by_zero, at(2));
    once.report(Id::division_by_zero, at(3));
    once.report(Id::no_program_end, at(4));
    EXPECT_EQ(kept.list().size(), 2u);
    EXPECT_EQ(once.left_out(), 2u);
    EXPECT_EQ(once.counts().errors(), 2u);
    EXPECT_EQ(once.counts().warnings(), 2u);
}

TEST(Fails, ErrorsAlwaysAndWarningsWhenDenied) {
    Counts clean, warned, wrong;
    warned.by_severity[static_cast<std::size_t>(Severity::warning)] = 1;
    wrong.by_severity[static_cast<std::size_t>(Severity::error)] = 1;
    EXPECT_FALSE(fails(clean, true));
    EXPECT_FALSE(fails(warned, false));
    EXPECT_TRUE(fails(warned, true));
    EXPECT_TRUE(fails(wrong, false));
}

}  // namespace
}  // namespace fagorc::diag
