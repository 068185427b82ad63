// fagorc: one binary, one file a subcommand.
#include <CLI/CLI.hpp>

#include <cstdio>
#include <exception>

#include "tools/fagorc/commands.hpp"
#include "tools/fagorc/version.hpp"

namespace {

/// What was printed without asking whether it arrived (help, explanations, findings) may have met a full disk.
fagorc::tool::Exit printed(fagorc::tool::Exit exit) {
    if (std::fflush(stdout) == 0 && !std::ferror(stdout)) return exit;
    std::perror("fagorc: standard output");
    return fagorc::tool::Exit::could_not_run;
}

}  // namespace

int main(int argc, char** argv) {
    using namespace fagorc::tool;
    CLI::App app{"Compiler, linter and translator for Fagor CNC part programs", "fagorc"};
    app.set_version_flag("--version", std::string("fagorc ") + version);
    app.require_subcommand(1);
    app.footer(
        "Examples:\n"
        "  fagorc compile part.pit -o part.ftj     exact moves, as a trajectory file\n"
        "  fagorc check part.pit                   findings, as the control's own alarms\n"
        "  fagorc explain F0606                    what a finding means and what cures it\n"
        "Exit codes: 0 no error, 1 errors found, 2 could not run.");
    Exit exit = Exit::ok;
    add_compile(app, exit);
    add_check(app, exit);
    add_dump(app, exit);
    add_verify(app, exit);
    add_explain(app, exit);
    add_completions(app, exit);
    add_manual(app, exit);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        return printed(app.exit(e) == 0 ? Exit::ok : Exit::could_not_run);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "fagorc: %s\n", e.what());
        return Exit::could_not_run;
    }
    return printed(exit);
}
