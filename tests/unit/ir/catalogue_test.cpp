// The catalogue: look-up, messages with arguments, alarms by axis and zone.
#include "ir/diag/catalogue.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "ir/diag/alarm.hpp"

namespace fagorc::diag {
namespace {

Diagnostic finding(Id id, std::vector<Argument> arguments = {}) {
    return {id, {}, std::move(arguments), {}};
}

TEST(Catalogue, FindsByCodeAndByNameInAnyCase) {
    EXPECT_EQ(find("F0205"), Id::axis_not_of_machine);
    EXPECT_EQ(find("f0205"), Id::axis_not_of_machine);
    EXPECT_EQ(find("axis_not_of_machine"), Id::axis_not_of_machine);
    EXPECT_EQ(find("F02"), std::nullopt);
    EXPECT_EQ(find(""), std::nullopt);
}

TEST(Catalogue, EveryRowIsFoundByItsCode) {
    for (std::size_t i = 0; i < row_count(); ++i) {
        const Id id = static_cast<Id>(i);
        EXPECT_EQ(find(row(id).code), id) << row(id).code;
        EXPECT_EQ(find(row(id).name), id) << row(id).name;
    }
}

// One number, a range by axis, a list by axis, and what belongs to no row.
TEST(Catalogue, FindsByTheNumberOfTheControl) {
    EXPECT_EQ(with_alarm("0043", "8055"), (std::vector<Id>{Id::coordinates_incomplete, Id::arc_centre_missing}));
    EXPECT_EQ(with_alarm("0043", "another"), std::vector<Id>{});
    EXPECT_EQ(with_alarm("", "8055"), std::vector<Id>{});
    for (std::size_t i = 0; i < row_count(); ++i) {
        const std::string_view all = row(static_cast<Id>(i)).alarm_8055;
        if (all.size() < alarm_digits) continue;
        for (const std::string_view number : {all.substr(0, alarm_digits), all.substr(all.size() - alarm_digits)}) {
            const auto found = with_alarm(number, "8055");
            EXPECT_NE(std::find(found.begin(), found.end(), static_cast<Id>(i)), found.end()) << number;
        }
    }
}

TEST(Catalogue, PutsArgumentsWhereTheLanguageWantsThem) {
    const Diagnostic d = finding(Id::repeat_labels_reversed, {10, 20});
    EXPECT_EQ(message(d, Language::english), "N20 stands before N10, so there is nothing to repeat");
    EXPECT_EQ(message(d, Language::french), "N20 se trouve avant N10, il n'y a donc rien à répéter");
    EXPECT_EQ(message(d, Language::spanish), "N20 está antes de N10, por eso no hay nada que repetir");
}

TEST(Catalogue, TranslatesArgumentsThatAreTexts) {
    const Diagnostic d = finding(Id::must_be_alone, {Text{"the stop", "l'arrêt", "la parada"}});
    EXPECT_EQ(message(d, Language::french), "l'arrêt doit être seul dans son bloc");
}

TEST(Catalogue, ArgumentsMayHoldBraces) {
    EXPECT_EQ(message(finding(Id::unknown_word, {"{0}"}), Language::english), "{0} is not a word of this control");
}

TEST(Catalogue, NumbersHaveTheDecimalsOfWords) {
    EXPECT_EQ(Argument(0.1).plain, "0.1");
    EXPECT_EQ(Argument(-2.0).plain, "-2");
    EXPECT_EQ(Argument(100.0).plain, "100");
    EXPECT_EQ(Argument(0.0).plain, "0");
    EXPECT_EQ(Argument(-0.0).plain, "0");
    EXPECT_EQ(Argument(7.0710678118654755).plain, "7.07107");
    EXPECT_EQ(Argument(99999.9999).plain, "99999.9999");
    EXPECT_EQ(Argument(0.0000012).plain, "1.2e-06");
    EXPECT_EQ(Argument(1e300).plain, "1e+300");
    EXPECT_EQ(Argument(7u).plain, "7");
}

TEST(Catalogue, AlarmIsTheControlsOwnNumber) {
    EXPECT_EQ(alarm(finding(Id::axis_not_of_machine, {'V'}), "8055"), "0046");
    EXPECT_EQ(alarm(finding(Id::cannot_read, {"a", "b"}), "8055"), "");
    EXPECT_EQ(alarm(finding(Id::axis_not_of_machine, {'V'}), "another"), "");
}

// The control numbers its axes X Y Z U V W A B C: 1155 is X, 1157 Z, 1163 C.
TEST(Catalogue, AxisChoosesInARangeOfAlarms) {
    const auto of = [](char axis) { return alarm(finding(Id::travel_limit_exceeded, {axis, 1.5, 1.0}), "8055"); };
    EXPECT_EQ(of('X'), "1155");
    EXPECT_EQ(of('Z'), "1157");
    EXPECT_EQ(of('C'), "1163");
    EXPECT_EQ(of('Q'), "");
}

// Zones 1 to 4 have alarms of their own, zone 5 has none.
TEST(Catalogue, ZoneChoosesInAListOfAlarms) {
    const auto of = [](int zone) { return alarm(finding(Id::forbidden_zone_entered, {zone}), "8055"); };
    EXPECT_EQ(of(1), "1090");
    EXPECT_EQ(of(2), "1091");
    EXPECT_EQ(of(3), "1096");
    EXPECT_EQ(of(4), "1097");
    EXPECT_EQ(of(5), "");
    EXPECT_EQ(of(0), "");
    EXPECT_EQ(alarm(finding(Id::forbidden_zone_entered), "8055"), "");
}

TEST(Catalogue, SeveritiesHaveNames) {
    EXPECT_EQ(to_string(Severity::warning, Language::french), "avertissement");
    EXPECT_EQ(to_string(Severity::error, Language::spanish), "error");
    EXPECT_EQ(to_string(Severity::note, Language::english), "note");
}

}  // namespace
}  // namespace fagorc::diag
