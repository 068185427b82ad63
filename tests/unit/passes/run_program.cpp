#include "tests/unit/passes/run_program.hpp"

#include <algorithm>

#include "frontend/controls/controls.hpp"
#include "frontend/machine/machine.hpp"
#include "ir/diag/catalogue.hpp"
#include "passes/execute/texts.hpp"

namespace fagorc::passes {
namespace {

struct Findings : diag::Sink {
    explicit Findings(std::vector<diag::Diagnostic>& out) : list(out) {}
    void report(diag::Diagnostic d) override { list.push_back(std::move(d)); }
    std::vector<diag::Diagnostic>& list;
};

struct Operations : operation::Sink {
    explicit Operations(std::vector<operation::Operation>& out) : list(out) {}
    void push(const operation::Operation& o) override { list.push_back(o); }
    std::vector<operation::Operation>& list;
};

struct Given : program::LiveValues {
    explicit Given(const std::map<std::string, double, std::less<>>& given) : values(given) {}
    std::optional<double> value(std::string_view name) override {
        const auto at = values.find(name);
        return at == values.end() ? std::nullopt : std::optional(at->second);
    }
    const std::map<std::string, double, std::less<>>& values;
};

std::optional<Point> end_of(const operation::What& what) {
    if (const auto* line = std::get_if<operation::Line>(&what)) return line->end;
    if (const auto* arc = std::get_if<operation::Arc>(&what)) return arc->end;
    if (const auto* thread = std::get_if<operation::Thread>(&what)) return thread->end;
    return std::nullopt;
}

}  // namespace

std::vector<std::string> ProgramRun::moves() const {
    std::vector<std::string> out;
    for (const auto& o : operations)
        if (const auto end = end_of(o.what)) out.push_back(written(end->v) + " " + written(end->u));
    return out;
}

std::string ProgramRun::errors() const {
    std::string out;
    for (const auto& d : findings) {
        const diag::Row& row = diag::row(d.id);
        if (row.severity != diag::Severity::error) continue;
        if (!out.empty()) out += ", ";
        out += std::string(row.name);
        if (!row.alarm_8055.empty()) out += " " + std::string(row.alarm_8055);
    }
    return out;
}

bool ProgramRun::has(diag::Id id) const {
    return std::any_of(findings.begin(), findings.end(), [&](const auto& d) { return d.id == id; });
}

ProgramRun run_program(std::string_view text, const RunOptions& options) {
    ProgramRun run;
    Findings findings(run.findings);
    Operations operations(run.operations);
    Given live(options.live);
    const control::Dialect& dialect = *frontend::dialect("8055");
    frontend::Workspace workspace(dialect, findings, options.caches);
    for (const auto& [name, program] : options.library) workspace.add(name, program);
    program::Program& program = workspace.add("part.pit", std::string(text));
    operation::Tables tables;
    EventTexts texts;
    run.result = execute(program, workspace.library(), dialect, frontend::built_in_lathe(dialect), live, tables, texts,
                         findings, operations, options.execute);
    run.statistics = workspace.statistics();
    for (const auto& o : run.operations) {
        run.chains.push_back(tables.chains[o.at.chain]);
        const auto* event = std::get_if<operation::Event>(&o.what);
        if (event && event->kind == operation::Event::Kind::message) run.messages.push_back(texts.list[event->text]);
    }
    return run;
}

std::string last_message(std::string_view text, const RunOptions& options) {
    const ProgramRun run = run_program(text, options);
    if (!run.errors().empty()) return run.errors();
    return run.messages.empty() ? "" : run.messages.back();
}

}  // namespace fagorc::passes
