// Each row of a control's tables that is executed stands in a program whose moves or events are written down: a golden
// file with an output, or an example with a table of moves. A new row without one fails here.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "frontend/controls/controls.hpp"
#include "frontend/frontend.hpp"
#include "frontend/scan/scanner.hpp"
#include "ir/diag/collection.hpp"

namespace fagorc {
namespace {

namespace fs = std::filesystem;
using control::Dialect;
using control::Support;
using program::Token;

std::string read(const fs::path& path) {
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

/// The programs of a golden file; none where it shows no output, only findings.
std::vector<std::string> programs_of_golden(const std::string& text) {
    static const std::set<std::string> outputs = {"csv", "json", "iso", "dump"};
    std::vector<std::string> programs;
    bool shows_output = false, inside = false;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        if (line.rfind("=== ", 0) != 0) {
            if (inside) programs.back() += line + '\n';
            continue;
        }
        std::istringstream words(line.substr(4));
        std::string kind, name, escaped;
        words >> kind >> name >> escaped;
        inside = (kind == "input" || kind == "library") && escaped.empty();
        if (inside) programs.emplace_back();
        shows_output = shows_output || (kind == "expect" && outputs.count(name) != 0);
    }
    return shows_output ? programs : std::vector<std::string>{};
}

std::vector<std::string> programs() {
    std::vector<std::string> all;
    for (const auto& entry : fs::recursive_directory_iterator("tests/golden"))
        if (entry.path().extension() == ".golden")
            for (std::string& program : programs_of_golden(read(entry.path()))) all.push_back(std::move(program));
    for (const auto& entry : fs::directory_iterator("tests/examples"))
        if (entry.path().extension() == ".moves") all.push_back(read(fs::path(entry.path()).replace_extension(".pit")));
    return all;
}

/// The name of the row that a token stands for; empty for none.
std::string row_of(const program::PlacedToken& token, const Dialect& dialect, bool iso) {
    if (token.kind == Token::g_code) return "G" + std::to_string(token.payload);
    if (token.kind == Token::m_code) return "M" + std::to_string(token.payload);
    if (token.kind == Token::skip) return "word /";
    if (token.kind == Token::variable)
        return "variable " + std::string(dialect.variables[control::variable_row(token.payload)].name);
    if (program::has_payload(token.kind)) return std::string(dialect.word(token.kind, token.payload));
    if (program::is_letter(token.kind))
        return iso ? std::string("word ") + static_cast<char>(token.kind) : std::string();
    return std::string(1, static_cast<char>(token.kind));
}

/// The rows that the sound blocks of all programs name.
std::set<std::string> seen(const Dialect& dialect) {
    std::set<std::string> rows;
    const frontend::Scanner scanner(dialect);
    frontend::Scan room(dialect.limits.block_bytes);
    for (std::string& text : programs()) {
        diag::Collection findings;
        frontend::Workspace workspace(dialect, findings);
        program::Program& program = workspace.add("part", std::move(text));
        for (program::Cursor at = program.first(); const program::Block* block = program.read(at); at = block->next) {
            if (block->shape->broken) continue;
            const bool iso = std::holds_alternative<program::IsoBlock>(block->shape->body);
            if (block->text.find(';') != std::string_view::npos) rows.insert("word ;");
            for (const program::PlacedToken& token : scanner.tokens(block->text.data(), room))
                rows.insert(row_of(token, dialect, iso));
        }
    }
    return rows;
}

class Coverage : public testing::TestWithParam<const char*> {
  protected:
    const Dialect& dialect_ = *frontend::dialect(GetParam());
    const std::set<std::string> seen_ = seen(dialect_);

    void expect(Support support, const std::string& row) const {
        EXPECT_TRUE(support == Support::planned || seen_.count(row)) << row << " stands in no golden program";
    }
};

TEST_P(Coverage, Codes) {
    for (const control::Construct* c : dialect_.constructs) expect(c->support, c->letter + std::to_string(c->number));
}

TEST_P(Coverage, StatementsAndOperators) {
    for (const control::StatementRow& row : dialect_.statements) expect(row.support, std::string(row.word));
    for (const control::StatementRow& row : dialect_.operators) expect(row.support, std::string(row.word));
}

TEST_P(Coverage, Addresses) {
    for (const control::StatementRow& row : dialect_.addresses) expect(row.support, "word " + std::string(row.word));
}

TEST_P(Coverage, Variables) {
    for (const control::Variable& v : dialect_.variables)
        if (v.readable || v.writable) expect(v.support, "variable " + std::string(v.name));
}

INSTANTIATE_TEST_SUITE_P(Controls, Coverage, testing::Values("8055"),
                         [](const auto& control) { return "Of" + std::string(control.param); });

}  // namespace
}  // namespace fagorc
