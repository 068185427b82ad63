// For programs: one JSON object a line, a contract (docs/diagnostics.md). Columns are bytes from 1.
#include <nlohmann/json.hpp>

#include "tools/fagorc/report/readable.hpp"
#include "tools/fagorc/report/reporters.hpp"

namespace fagorc::report {
namespace {

using Object = nlohmann::ordered_json;

class Json final : public Reporter {
  public:
    explicit Json(Output output) : out_(std::move(output)) {}

    using Reporter::report;
    void report(diag::Diagnostic d) override {
        const Language language = out_.options.language;
        Object o = place(d.place);
        o["severity"] = diag::to_string(diag::row(d.id).severity, Language::english);
        o["code"] = diag::row(d.id).code;
        if (const std::string alarm = diag::alarm(d, out_.options.control); !alarm.empty()) o["alarm"] = alarm;
        o["message"] = readable(diag::message(d, language));
        o["related"] = Object::array();
        for (const diag::Label& label : d.related) {
            Object r = place(label.place);
            r["message"] = label.text.in(language);
            o["related"].push_back(std::move(r));
        }
        out_.write(o.dump() + '\n');
    }

    void finish(const diag::Counts&, std::uint64_t) override {}

  private:
    Object place(const diag::Place& p) const {
        return {
            {"file", file_name(out_.texts, p)}, {"line", p.line}, {"column", p.column}, {"end_column", p.end_column}};
    }

    Output out_;
};

}  // namespace

std::unique_ptr<Reporter> make_json(Output output) {
    return std::make_unique<Json>(std::move(output));
}

}  // namespace fagorc::report
