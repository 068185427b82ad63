// Sweeps the specification tables, where they are: every code, statement and operator there has its row here.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "frontend/controls/controls.hpp"

namespace fagorc {
namespace {

using control::Dialect;

std::vector<std::string> fields(const std::string& line) {
    std::vector<std::string> out(1);
    for (char c : line) {
        if (c == '\t') {
            out.emplace_back();
        } else {
            out.back() += c;
        }
    }
    return out;
}

/// The folder of the specification: FAGORC_SPECIFICATION, or where it lies beside the project.
std::filesystem::path specification() {
    const char* given = std::getenv("FAGORC_SPECIFICATION");
    return given ? given : "../shared/spec";
}

/// The rows of a kind of the specification of the 8055.
std::vector<std::vector<std::string>> rows(const std::set<std::string>& kinds) {
    std::vector<std::vector<std::string>> out;
    for (const char* sheet : {"8055-core", "8055-language", "8055-cycles"}) {
        std::ifstream in(specification() / (std::string(sheet) + ".tsv"));
        for (std::string line; std::getline(in, line);)
            if (auto f = fields(line); f.size() >= 6 && kinds.count(f[1])) out.push_back(f);
    }
    return out;
}

const Dialect& lathe() {
    return *frontend::dialect("8055");
}

TEST(Specification, EachCodeHasItsRow) {
    const auto table = rows({"G", "M", "cycle"});
    if (table.empty()) GTEST_SKIP() << "the specification tables are not here";
    const std::regex code("\\.([GM])(\\d+)");
    int checked = 0;
    for (const auto& row : table) {
        std::smatch m;
        if (!std::regex_search(row[0], m, code)) continue;  // a rule about several codes
        const auto number = static_cast<std::uint16_t>(std::stoi(m[2]));
        EXPECT_NE(lathe().find(*m[1].first, number), nullptr) << row[0];
        ++checked;
    }
    EXPECT_GT(checked, 300);
}

TEST(Specification, ModalCodesAreModalHere) {
    const auto table = rows({"G"});
    if (table.empty()) GTEST_SKIP() << "the specification tables are not here";
    // G92, G93 and G53 alone set an origin that stays, but the codes themselves act once
    const std::set<int> act_once{53, 92, 93};
    const std::regex code("8055\\.(?:annexA\\.)?G(\\d+)");
    for (const auto& row : table) {
        std::smatch m;
        if (row[3] == "-" || !std::regex_match(row[0], m, code)) continue;
        const auto* construct = lathe().find('G', static_cast<std::uint16_t>(std::stoi(m[1])));
        ASSERT_NE(construct, nullptr) << row[0];
        if (act_once.count(construct->number) == 0) {
            EXPECT_EQ(construct->modal(), row[3] == "yes") << row[0];
        }
    }
}

TEST(Specification, EachWordOfACycleHasItsOperand) {
    const auto table = rows({"word"});
    if (table.empty()) GTEST_SKIP() << "the specification tables are not here";
    const std::regex word("8055\\.G(\\d+)\\.([A-Z])");
    int checked = 0;
    for (const auto& row : table) {
        std::smatch m;
        if (!std::regex_match(row[0], m, word)) continue;
        const auto* construct = lathe().find('G', static_cast<std::uint16_t>(std::stoi(m[1])));
        ASSERT_NE(construct, nullptr) << row[0];
        EXPECT_NE(construct->operand(*m[2].first), nullptr) << row[0];
        ++checked;
    }
    EXPECT_GT(checked, 150);
}

TEST(Specification, EachWordOfAProbingCycleHasItsOperand) {
    const auto table = rows({"word"});
    if (table.empty()) GTEST_SKIP() << "the specification tables are not here";
    const std::regex word("8055\\.PROBE(\\d)\\.([A-Z])");
    int checked = 0;
    for (const auto& row : table) {
        std::smatch m;
        if (!std::regex_match(row[0], m, word)) continue;
        const auto* statement = lathe().find_statement("PROBE " + m[1].str());
        ASSERT_NE(statement, nullptr) << row[0];
        const auto named = [&](const control::Operand& o) { return o.address == *m[2].first; };
        EXPECT_TRUE(std::any_of(statement->operands.begin(), statement->operands.end(), named)) << row[0];
        ++checked;
    }
    EXPECT_GT(checked, 25);
}

TEST(Specification, EachStatementHasItsRow) {
    const auto table = rows({"statement"});
    if (table.empty()) GTEST_SKIP() << "the specification tables are not here";
    const std::regex word("^\\(([A-Z]+)");
    int checked = 0;
    for (const auto& row : table) {
        std::smatch m;
        if (!std::regex_search(row[5], m, word)) continue;
        const std::string name = m[1];
        const bool numbered = name.back() == 'n';
        EXPECT_NE(lathe().find_statement(numbered ? name.substr(0, name.size() - 1) : name), nullptr) << row[0];
        ++checked;
    }
    EXPECT_GT(checked, 40);
}

TEST(Specification, EachOperatorHasItsRow) {
    const auto table = rows({"operator"});
    if (table.empty()) GTEST_SKIP() << "the specification tables are not here";
    const std::regex name("8055\\.op\\.([A-Z]+|[-+*/])");
    for (const auto& row : table) {
        std::smatch m;
        if (!std::regex_match(row[0], m, name)) continue;
        const auto known = [&](const control::StatementRow& r) { return r.word == m[1].str(); };
        EXPECT_EQ(std::count_if(lathe().operators.begin(), lathe().operators.end(), known), 1) << row[0];
    }
}

TEST(Specification, EachVariableHasItsRowWithItsAccess) {
    const auto table = rows({"variable"});
    if (table.empty()) GTEST_SKIP() << "the specification tables are not here";
    const std::regex name("8055\\.var\\.([A-Z]+)n?(\\(X(?:-|\\.\\.)C\\))?(?:n(?:_p)?|_id)?");
    const std::regex access("\\[CNC ([RW/-]+),");
    int checked = 0;
    for (const auto& row : table) {
        std::smatch m, allowed;
        if (!std::regex_match(row[0], m, name) || !std::regex_search(row[5], allowed, access)) continue;
        const auto same = [&](const control::Variable& v) {
            return v.name == m[1].str() && v.per_axis == m[2].matched;
        };
        const auto found = std::find_if(lathe().variables.begin(), lathe().variables.end(), same);
        ASSERT_NE(found, lathe().variables.end()) << row[0];
        const std::string cnc = allowed[1];
        const bool stops = row[5].find("stops block preparation") != std::string::npos;
        EXPECT_EQ(found->readable, cnc.find('R') != std::string::npos) << row[0];
        EXPECT_EQ(found->stops_preparation, stops) << row[0];
        if (found->index !=
            control::IndexForm::optional) {  // ORGX is read-only, ORGX54 is not: two rows there, one here
            EXPECT_EQ(found->writable, cnc.find('W') != std::string::npos) << row[0];
        }
        ++checked;
    }
    EXPECT_GT(checked, 250);
}

}  // namespace
}  // namespace fagorc
