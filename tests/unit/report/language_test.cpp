// The language and the colours that the environment asks for.
#include "tools/fagorc/report/language.hpp"

#include <gtest/gtest.h>

#include <map>
#include <string>

namespace fagorc::report {
namespace {

Environment with(std::map<std::string, const char*> variables) {
    return [variables = std::move(variables)](const char* name) -> const char* {
        const auto at = variables.find(name);
        return at == variables.end() ? nullptr : at->second;
    };
}

TEST(LanguageTest, TakesTheNamesOfTheOption) {
    EXPECT_EQ(language_of("fr"), Language::french);
    EXPECT_EQ(language_of("es"), Language::spanish);
    EXPECT_EQ(language_of("en"), Language::english);
    EXPECT_EQ(language_of("de"), std::nullopt);
}

TEST(LanguageTest, FollowsTheLocale) {
    EXPECT_EQ(language_of_environment(with({{"LANG", "fr_FR.UTF-8"}})), Language::french);
    EXPECT_EQ(language_of_environment(with({{"LANG", "es"}})), Language::spanish);
    EXPECT_EQ(language_of_environment(with({{"LANG", "fr@euro"}})), Language::french);
    EXPECT_EQ(language_of_environment(with({{"LANG", "de_DE"}})), Language::english);
    EXPECT_EQ(language_of_environment(with({{"LANG", "frx"}})), Language::english);
    EXPECT_EQ(language_of_environment(with({})), Language::english);
}

TEST(LanguageTest, TheFirstVariableThatIsSetDecides) {
    EXPECT_EQ(language_of_environment(with({{"LC_ALL", "es_ES"}, {"LANG", "fr_FR"}})), Language::spanish);
    EXPECT_EQ(language_of_environment(with({{"LC_MESSAGES", "es_ES"}, {"LANG", "fr_FR"}})), Language::spanish);
    EXPECT_EQ(language_of_environment(with({{"LC_ALL", "C"}, {"LANG", "fr_FR"}})), Language::english);
    EXPECT_EQ(language_of_environment(with({{"LC_ALL", ""}, {"LANG", "fr_FR"}})), Language::french);
}

TEST(ColorTest, AutomaticOnATerminalWithoutNoColor) {
    EXPECT_TRUE(color_wanted(Color::automatic, true, with({})));
    EXPECT_FALSE(color_wanted(Color::automatic, false, with({})));
    EXPECT_FALSE(color_wanted(Color::automatic, true, with({{"NO_COLOR", "1"}})));
    EXPECT_TRUE(color_wanted(Color::automatic, true, with({{"NO_COLOR", ""}})));
    EXPECT_FALSE(color_wanted(Color::automatic, true, with({{"TERM", "dumb"}})));
}

TEST(ColorTest, TheOptionWins) {
    EXPECT_TRUE(color_wanted(Color::always, false, with({{"NO_COLOR", "1"}})));
    EXPECT_FALSE(color_wanted(Color::never, true, with({})));
    EXPECT_EQ(color_of("auto"), Color::automatic);
    EXPECT_EQ(color_of("always"), Color::always);
    EXPECT_EQ(color_of("sometimes"), std::nullopt);
}

}  // namespace
}  // namespace fagorc::report
