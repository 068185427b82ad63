// The nearest name: typing slips are found, different words are left alone.
#include "ir/base/nearest.hpp"

#include <gtest/gtest.h>

#include <array>

namespace fagorc {
namespace {

constexpr std::array<std::string_view, 5> names = {"CIRINERR", "IPLANE", "units", "min", "max"};

TEST(Nearest, FindsSlips) {
    EXPECT_EQ(nearest("CIRINER", names), "CIRINERR");  // a letter left out
    EXPECT_EQ(nearest("unitss", names), "units");      // one too many
    EXPECT_EQ(nearest("IPLAEN", names), "IPLANE");     // two swapped
    EXPECT_EQ(nearest("Units", names), "units");       // letter case is no difference
    EXPECT_EQ(nearest("mix", names), "min");           // the first of two at the same distance
}

TEST(Nearest, LeavesDifferentWordsAlone) {
    EXPECT_EQ(nearest("feed", names), "");
    EXPECT_EQ(nearest("a", names), "");
    EXPECT_EQ(nearest("", names), "");
    EXPECT_EQ(nearest("units", {}), "");
}

}  // namespace
}  // namespace fagorc
