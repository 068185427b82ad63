// fagorc check: runs a program against the machine and shows what is wrong with it.
#include <CLI/CLI.hpp>

#include <memory>
#include <string>
#include <vector>

#include "tools/fagorc/commands.hpp"
#include "tools/fagorc/part.hpp"
#include "tools/fagorc/progress.hpp"
#include "tools/fagorc/report/language.hpp"

namespace fagorc::tool {
namespace {

struct Options {
    Settings settings;
    std::vector<std::string> parts;
};

/// A check has no output but its findings.
struct Nowhere final : operation::Sink {
    void push(const operation::Operation&) override {}
};

Exit check(const Options& options) {
    Console console(options.settings, stdout);
    std::vector<std::unique_ptr<Part>> parts;
    bool all_ran = true;
    for (const std::string& path : options.parts) {
        Part& part = *parts.emplace_back(std::make_unique<Part>(options.settings, console));
        if (!part.load(path)) {
            all_ran = false;
            continue;
        }
        Nowhere nowhere;
        Progress progress(nowhere, nullptr, report::is_terminal(stderr));
        part.run(progress, {.stop_after = {}, .checking = true});
    }
    console.finish();
    return all_ran ? console.outcome() : Exit::could_not_run;
}

}  // namespace

void add_check(CLI::App& app, Exit& exit) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("check", "Show what is wrong with programs");
    command->add_option("PART", options->parts, "program files; - is standard input")->required();
    add_program_options(*command, options->settings);
    command->footer(
        "Examples:\n"
        "  fagorc check part.pit\n"
        "  fagorc check --machine lathe.toml --library programs --lang fr *.pit\n"
        "  fagorc check --format sarif part.pit > part.sarif\n"
        "A value that only the machine knows is no error here: the path that needs it ends.");
    command->callback([options, &exit] { exit = check(*options); });
}

}  // namespace fagorc::tool
