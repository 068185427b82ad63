// For editors and scripts: one line a finding, `file:line:column: error F0205 [alarm 0046]: message`.
#include <fmt/format.h>

#include "tools/fagorc/report/readable.hpp"
#include "tools/fagorc/report/reporters.hpp"

namespace fagorc::report {
namespace {

class Brief final : public Reporter {
  public:
    explicit Brief(Output output) : out_(std::move(output)) {}

    using Reporter::report;
    void report(diag::Diagnostic d) override {
        std::string where = file_name(out_.texts, d.place);
        if (where.empty()) where = "fagorc";
        if (d.place.line > 0) where += fmt::format(":{}:{}", d.place.line, d.place.column);
        out_.write(fmt::format("{}: {}: {}\n", where, headline(d, out_.options),
                               readable(diag::message(d, out_.options.language))));
    }

    void finish(const diag::Counts&, std::uint64_t left_out) override {
        if (left_out > 0) out_.write(fmt::format("fagorc: {}\n", not_shown(left_out, out_.options.language)));
    }

  private:
    Output out_;
};

}  // namespace

std::unique_ptr<Reporter> make_brief(Output output) {
    return std::make_unique<Brief>(std::move(output));
}

}  // namespace fagorc::report
