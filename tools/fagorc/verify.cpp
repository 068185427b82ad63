// fagorc verify: whether every byte of trajectory files is as it was written.
#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "tools/fagorc/commands.hpp"
#include "tools/fagorc/console.hpp"
#include "tools/fagorc/trajectory/file.hpp"
#include "tools/fagorc/trajectory/trajectory.hpp"

namespace fagorc::tool {
namespace {

struct Options {
    Settings settings;
    std::vector<std::string> files;
};

Exit verify(const Options& o) {
    Console console(o.settings, stderr);
    const frontend::Workspace* no_programs = nullptr;
    diag::Sink& out = console.sink_of(no_programs);
    bool all_read = true;
    for (const std::string& name : o.files) {
        FileBytes file;
        if (!file.open(name, out))
            all_read = false;
        else if (verify_trajectory(name, file.bytes(), out) && !o.settings.quiet)
            std::printf("%s: sound\n", name.c_str());
    }
    console.finish();
    return all_read ? console.outcome() : Exit::could_not_run;
}

}  // namespace

void add_verify(CLI::App& app, Exit& exit) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("verify", "Check every byte of trajectory files");
    command->add_option("FILE", options->files, "trajectory files; - is standard input")->required();
    add_report_options(*command, options->settings);
    command->footer("Examples:\n  fagorc verify part.ftj\n  fagorc compile part.pit -o - | fagorc verify -");
    command->callback([options, &exit] { exit = verify(*options); });
}

}  // namespace fagorc::tool
