// The explain pages: every code has one, in three languages, with the examples that its kind asks for.
#include "ir/diag/explain.hpp"

#include <gtest/gtest.h>

#include <filesystem>

#include "ir/diag/catalogue.hpp"

namespace fagorc::diag {
namespace {

TEST(Explain, EveryCodeHasItsPageInThreeLanguages) {
    for (std::size_t i = 0; i < row_count(); ++i) {
        const Id id = static_cast<Id>(i);
        for (Language l : {Language::english, Language::french, Language::spanish})
            EXPECT_GT(explain_page(id, l).size(), 20u)
                << "ir/diag/explain/" << row(id).code << ".md: section missing in language " << static_cast<int>(l);
    }
}

TEST(Explain, APageShowsAProgramOrSaysWhyNot) {
    for (std::size_t i = 0; i < row_count(); ++i) {
        const Id id = static_cast<Id>(i);
        const bool programs = !explain_examples(id).empty();
        EXPECT_EQ(programs, explain_examples_kind(id) != Examples::none) << row(id).code;
    }
}

TEST(Explain, EveryPageBelongsToACode) {
    for (const auto& file : std::filesystem::directory_iterator("ir/diag/explain")) {
        if (file.path().filename() == "README.md") continue;
        const auto id = find(file.path().stem().string());
        ASSERT_TRUE(id) << file.path();
        EXPECT_EQ(row(*id).code, file.path().stem().string());
    }
}

TEST(Explain, SectionsAndExamplesAreTakenApart) {
    const std::string_view french = explain_page(Id::axis_not_of_machine, Language::french);
    EXPECT_EQ(french.find("Un mot d'axe"), 0u) << french;
    EXPECT_EQ(french.find("##"), french.npos);
    EXPECT_EQ(french.find("```"), french.npos);
    const auto programs = explain_examples(Id::axis_not_of_machine);
    ASSERT_EQ(programs.size(), 2u);
    EXPECT_NE(programs[0].find("G90 G01 V10 F100\n"), programs[0].npos);
    EXPECT_NE(programs[1].find("G90 G01 X10 F100\n"), programs[1].npos);
    EXPECT_EQ(explain_examples_kind(Id::axis_not_of_machine), Examples::shown);
    EXPECT_EQ(explain_examples_kind(Id::cannot_read), Examples::none);
}

}  // namespace
}  // namespace fagorc::diag
