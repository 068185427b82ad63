// The four reporters on small programs.
#include "tools/fagorc/report/reporter.hpp"

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "ir/diag/explain.hpp"

namespace fagorc::report {
namespace {

using diag::Diagnostic;
using diag::Id;
using diag::Place;
using nlohmann::json;

class Texts final : public SourceTexts {
  public:
    std::string file = "part.pit";
    std::map<std::uint64_t, std::string> lines;
    std::string_view name(diag::FileId) const override { return file; }
    std::string_view line_at(diag::FileId, std::uint64_t offset) const override {
        const auto at = lines.find(offset);
        return at == lines.end() ? std::string_view{} : std::string_view(at->second);
    }
};

struct ReporterTest : testing::Test {
    Texts texts;
    Options options;
    std::string printed;

    ReporterTest() { texts.lines = {{0, "%V,MX,"}, {7, "G151"}, {12, "G90 G01 V10 F100"}}; }

    static Place word() { return {diag::FileId{0}, 3, 9, 12, 12}; }

    std::string print(Format format, const std::vector<Diagnostic>& findings, std::uint64_t left_out = 0) {
        printed.clear();
        diag::Counts counts;
        const auto reporter = make_reporter(
            format, [&](std::string_view s) { printed += s; }, texts, options);
        for (const Diagnostic& d : findings) {
            ++counts.by_severity[static_cast<std::size_t>(diag::row(d.id).severity)];
            reporter->report(d);
        }
        reporter->finish(counts, left_out);
        return printed;
    }
};

TEST_F(ReporterTest, FormatsHaveNames) {
    EXPECT_EQ(format_of("human"), Format::human);
    EXPECT_EQ(format_of("short"), Format::brief);
    EXPECT_EQ(format_of("json"), Format::json);
    EXPECT_EQ(format_of("sarif"), Format::sarif);
    EXPECT_EQ(format_of("xml"), std::nullopt);
}

TEST_F(ReporterTest, HumanShowsTheWordAndWhereHelpIs) {
    EXPECT_EQ(print(Format::human, {{Id::axis_not_of_machine, word(), {'V'}, {}}}),
              "error F0205 [alarm 0046]: the machine has no axis V\n"
              " --> part.pit:3:9\n"
              "3 | G90 G01 V10 F100\n"
              "  |         ^^^\n"
              "  = help: fagorc explain F0205\n"
              "\n"
              "1 error\n");
}

TEST_F(ReporterTest, HumanShowsRelatedPlacesWithTheirText) {
    const Place since{diag::FileId{0}, 2, 1, 5, 7};
    const Diagnostic d{Id::axis_not_of_machine,
                       word(),
                       {'V'},
                       {{since, {"diameter since here", "diamètre depuis ici", "diámetro desde aquí"}}}};
    options.language = Language::french;
    EXPECT_EQ(print(Format::human, {d}),
              "erreur F0205 [alarme 0046]: la machine n'a pas d'axe V\n"
              " --> part.pit:3:9\n"
              "3 | G90 G01 V10 F100\n"
              "  |         ^^^\n"
              " ::: part.pit:2:1\n"
              "2 | G151\n"
              "  | ^^^^ diamètre depuis ici\n"
              "  = aide: fagorc explain F0205\n"
              "\n"
              "1 erreur\n");
}

TEST_F(ReporterTest, HumanWithoutAPlaceOrATextIsTheMessage) {
    EXPECT_EQ(print(Format::human, {{Id::set_value_malformed, {}, {"A"}, {}}}),
              "error F0331: --set takes NAME=NUMBER, not A\n"
              "  = help: fagorc explain F0331\n"
              "\n"
              "1 error\n");
    const Place gone{diag::FileId{0}, 9, 1, 2, 999};
    EXPECT_NE(print(Format::human, {{Id::empty_block, gone, {}, {}}}).find(" --> part.pit:9:1\n  = help"),
              std::string::npos);
}

TEST_F(ReporterTest, HumanCountsInTheSummary) {
    const std::string all = print(
        Format::human,
        {{Id::empty_block, word(), {}, {}}, {Id::empty_block, word(), {}, {}}, {Id::no_program_end, word(), {}, {}}},
        4);
    EXPECT_NE(all.find("\n2 errors, 1 warning, 4 not shown\n"), std::string::npos) << all;
    EXPECT_EQ(print(Format::human, {}), "") << "silence when all is well";
}

TEST_F(ReporterTest, HumanPutsColoursInOnlyWhenAsked) {
    const std::vector<Diagnostic> one{{Id::axis_not_of_machine, word(), {'V'}, {}}};
    EXPECT_EQ(print(Format::human, one).find('\x1b'), std::string::npos);
    const std::string plain = printed;
    options.color = true;
    std::string colored = print(Format::human, one);
    EXPECT_NE(colored.find("\x1b[1;31m^^^\x1b[0m"), std::string::npos);
    for (std::size_t at; (at = colored.find('\x1b')) != colored.npos;)
        colored.erase(at, colored.find('m', at) - at + 1);
    EXPECT_EQ(colored, plain);
}

TEST_F(ReporterTest, ShortIsOneLineAFinding) {
    EXPECT_EQ(print(Format::brief, {{Id::axis_not_of_machine, word(), {'V'}, {}}, {Id::pipe_closed, {}, {}, {}}}),
              "part.pit:3:9: error F0205 [alarm 0046]: the machine has no axis V\n"
              "fagorc: error F0903: the reader of the output has closed it\n");
    EXPECT_EQ(print(Format::brief, {}, 12), "fagorc: 12 not shown\n");
}

TEST_F(ReporterTest, JsonHoldsTheMembersOfTheContract) {
    const Place since{diag::FileId{0}, 2, 1, 5, 7};
    const Diagnostic d{Id::axis_not_of_machine, word(), {'V'}, {{since, {"here", "ici", "aquí"}}}};
    EXPECT_EQ(
        print(Format::json, {d}),
        "{\"file\":\"part.pit\",\"line\":3,\"column\":9,\"end_column\":12,\"severity\":\"error\",\"code\":\"F0205\","
        "\"alarm\":\"0046\",\"message\":\"the machine has no axis V\",\"related\":[{\"file\":\"part.pit\","
        "\"line\":2,\"column\":1,\"end_column\":5,\"message\":\"here\"}]}\n");
    const json without = json::parse(print(Format::json, {{Id::no_program_end, word(), {}, {}}}));
    EXPECT_FALSE(without.contains("alarm"));
    EXPECT_EQ(without["severity"], "warning");
    EXPECT_TRUE(without["related"].empty());
}

TEST_F(ReporterTest, JsonIsValidWhateverBytesComeIn) {
    texts.file = "p\xE9\xFF.pit";
    const json o = json::parse(print(Format::json, {{Id::unknown_word, word(), {"\xC3\x28\n\"\\"}, {}}}));
    EXPECT_EQ(o["file"], "péÿ.pit");
    EXPECT_EQ(o["message"], "Ã(␊\"\\ is not a word of this control");
}

// The members that the schema of SARIF 2.1.0 requires: version, runs; tool; driver; name; rules: id; results: message;
// regions count from 1 in the unit that columnKind names.
TEST_F(ReporterTest, SarifHoldsTheRequiredMembers) {
    options.version = "0.1.0";
    texts.file =
        "a folder/pi\xC3\xA8"
        "ce.pit";
    texts.lines[12] = "é G01 V10";
    const Place place{diag::FileId{0}, 3, 8, 11, 12};
    const json document = json::parse(print(Format::sarif, {{Id::axis_not_of_machine, place, {'V'}, {}},
                                                            {Id::no_program_end, place, {}, {}},
                                                            {Id::axis_not_of_machine, place, {'W'}, {}}}));
    EXPECT_EQ(document["version"], "2.1.0");
    ASSERT_EQ(document["runs"].size(), 1u);
    const json& run = document["runs"][0];
    EXPECT_EQ(run["tool"]["driver"]["name"], "fagorc");
    EXPECT_EQ(run["tool"]["driver"]["version"], "0.1.0");
    EXPECT_EQ(run["columnKind"], "unicodeCodePoints");
    const json& rules = run["tool"]["driver"]["rules"];
    ASSERT_EQ(rules.size(), 2u) << "one rule a code";
    EXPECT_EQ(rules[0]["id"], "F0205");
    EXPECT_EQ(rules[0]["help"]["text"], diag::explain_page(Id::axis_not_of_machine, Language::english));
    ASSERT_EQ(run["results"].size(), 3u);
    const json& result = run["results"][2];
    EXPECT_EQ(result["ruleId"], "F0205");
    EXPECT_EQ(result["ruleIndex"], 0);
    EXPECT_EQ(result["level"], "error");
    EXPECT_EQ(result["message"]["text"], "the machine has no axis W");
    EXPECT_EQ(result["properties"]["alarm"], "0046");
    const json& physical = result["locations"][0]["physicalLocation"];
    EXPECT_EQ(physical["artifactLocation"]["uri"], "a%20folder/pi%C3%A8ce.pit");
    EXPECT_EQ(physical["region"]["startLine"], 3);
    EXPECT_EQ(physical["region"]["startColumn"], 7) << "é is two bytes and one character";
    EXPECT_EQ(physical["region"]["endColumn"], 10);
    EXPECT_EQ(physical["region"]["byteOffset"], 19);
    EXPECT_EQ(physical["region"]["byteLength"], 3);
}

TEST_F(ReporterTest, SarifWithoutFindingsIsADocumentToo) {
    const json document = json::parse(print(Format::sarif, {}));
    EXPECT_TRUE(document["runs"][0]["results"].is_array());
    EXPECT_TRUE(document["runs"][0]["results"].empty());
}

}  // namespace
}  // namespace fagorc::report
