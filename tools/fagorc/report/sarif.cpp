// For code-scanning services: one SARIF 2.1.0 document, its rules taken from the catalogue.
#include <fmt/format.h>

#include <map>
#include <nlohmann/json.hpp>

#include "ir/diag/explain.hpp"
#include "tools/fagorc/report/readable.hpp"
#include "tools/fagorc/report/reporters.hpp"

namespace fagorc::report {
namespace {

using Object = nlohmann::ordered_json;

/// A path as a relative or absolute URI reference (RFC 3986): everything but the unreserved characters is escaped.
std::string uri(std::string_view path) {
    std::string out;
    for (char c : path) {
        const bool letter = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        if (letter || std::string_view("-._~/").find(c) != std::string_view::npos)
            out += c;
        else
            out += fmt::format("%{:02X}", static_cast<unsigned char>(c));
    }
    return out;
}

class Sarif final : public Reporter {
  public:
    explicit Sarif(Output output) : out_(std::move(output)) {}

    using Reporter::report;
    void report(diag::Diagnostic d) override {
        const diag::Row& row = diag::row(d.id);
        Object result{{"ruleId", row.code},
                      {"ruleIndex", rule_index(d.id)},
                      {"level", diag::to_string(row.severity, Language::english)},
                      {"message", {{"text", readable(diag::message(d, out_.options.language))}}}};
        if (d.place.file != diag::FileId::none) result["locations"] = {{{"physicalLocation", location(d.place)}}};
        for (const diag::Label& label : d.related)
            result["relatedLocations"].push_back({{"physicalLocation", location(label.place)},
                                                  {"message", {{"text", label.text.in(out_.options.language)}}}});
        if (const std::string alarm = diag::alarm(d, out_.options.control); !alarm.empty())
            result["properties"]["alarm"] = alarm;
        results_.push_back(std::move(result));
    }

    void finish(const diag::Counts&, std::uint64_t) override {
        Object driver{{"name", "fagorc"}};
        if (!out_.options.version.empty()) driver["version"] = out_.options.version;
        driver["rules"] = std::move(rules_);
        const Object document{{"$schema", "https://json.schemastore.org/sarif-2.1.0.json"},
                              {"version", "2.1.0"},
                              {"runs",
                               {{{"tool", {{"driver", std::move(driver)}}},
                                 {"columnKind", "unicodeCodePoints"},
                                 {"results", std::move(results_)}}}}};
        out_.write(document.dump(1) + '\n');
    }

  private:
    /// The place of a code in the document's rules; a rule is written when its first finding comes.
    std::size_t rule_index(diag::Id id) {
        const auto [at, added] = rule_of_.try_emplace(id, rules_.size());
        if (added) rules_.push_back(rule(id));
        return at->second;
    }

    Object rule(diag::Id id) const {
        const diag::Row& row = diag::row(id);
        const Language language = out_.options.language;
        Object rule{{"id", row.code},
                    {"name", row.name},
                    {"shortDescription", {{"text", row.message.in(language)}}},
                    {"defaultConfiguration", {{"level", diag::to_string(row.severity, Language::english)}}}};
        if (const std::string_view page = diag::explain_page(id, language); !page.empty())
            rule["help"] = {{"text", page}, {"markdown", page}};
        return rule;
    }

    /// SARIF counts columns in characters, we in bytes: both stand here.
    Object location(const diag::Place& p) const {
        Object location{{"artifactLocation", {{"uri", uri(out_.texts.name(p.file))}}}};
        if (p.line == 0) return location;
        const std::string_view line = out_.texts.line_at(p.file, p.block);
        const std::uint32_t begin = std::max(p.column, 1u), end = std::max(p.end_column, begin);
        location["region"] = {{"startLine", p.line},
                              {"startColumn", code_points_before(line, begin - 1) + 1},
                              {"endColumn", code_points_before(line, end - 1) + 1},
                              {"byteOffset", p.block + begin - 1},
                              {"byteLength", end - begin}};
        return location;
    }

    Output out_;
    Object rules_ = Object::array();
    Object results_ = Object::array();
    std::map<diag::Id, std::size_t> rule_of_;
};

}  // namespace

std::unique_ptr<Reporter> make_sarif(Output output) {
    return std::make_unique<Sarif>(std::move(output));
}

}  // namespace fagorc::report
