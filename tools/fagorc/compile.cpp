// fagorc compile: the main job, a program becomes the moves that the control would make.
#include <CLI/CLI.hpp>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <system_error>

#include "backends/output.hpp"
#include "tools/fagorc/commands.hpp"
#include "tools/fagorc/form.hpp"
#include "tools/fagorc/interrupt.hpp"
#include "tools/fagorc/part.hpp"
#include "tools/fagorc/progress.hpp"
#include "tools/fagorc/report/language.hpp"

namespace fagorc::tool {
namespace {

struct Options {
    Settings settings;
    FormOptions form;
    std::string part, output;
    bool stream = false, statistics = false;
};

std::unique_ptr<backends::Output> open_output(const Options& o) {
    if (o.output != "-") return backends::open_file(o.output);
    return o.stream ? backends::open_standard_output() : backends::open_held_standard_output(most_held_back);
}

/// The program's own name with the form's suffix, or standard output for standard input.
std::string default_output(const std::string& part, const Form& form) {
    return part == "-" ? "-" : std::filesystem::path(part).replace_extension(form.name).string();
}

void print_statistics(Part& part, double seconds, std::uint64_t blocks, std::uint64_t moves) {
    const frontend::Statistics s = part.workspace().statistics();
    std::fprintf(stderr,
                 "blocks %llu\nshapes %llu\nparser calls %llu\nmoves %llu\nseconds %.6f\nblocks per second %.0f\n",
                 static_cast<unsigned long long>(blocks), static_cast<unsigned long long>(s.shapes),
                 static_cast<unsigned long long>(s.parser_calls), static_cast<unsigned long long>(moves), seconds,
                 seconds > 0 ? static_cast<double>(blocks) / seconds : 0);
}

void print_summary(const Options& o, Part& part, std::uint64_t moves, std::uint64_t blocks) {
    std::fprintf(stderr, "%s -> %s: %llu moves of %llu blocks, machine: %s\n", o.part.c_str(), o.output.c_str(),
                 static_cast<unsigned long long>(moves), static_cast<unsigned long long>(blocks),
                 part.machine_name().c_str());
}

Exit compile(Options& o) {
    const auto begin = std::chrono::steady_clock::now();
    const Form* form = o.form.form.empty() ? form_of_file(o.output) : form_named(o.form.form);
    if (!form) {
        std::fprintf(stderr, "fagorc: no form of output ends in the suffix of %s; choose one with --to\n",
                     o.output.c_str());
        return Exit::could_not_run;
    }
    if (o.output.empty()) o.output = default_output(o.part, *form);
    std::error_code no_such_file;
    if (std::filesystem::equivalent(o.part, o.output, no_such_file)) {
        std::fprintf(stderr, "fagorc: %s would replace the program itself; choose another output with -o\n",
                     o.output.c_str());
        return Exit::could_not_run;
    }
    Console console(o.settings, stderr);
    Part part(o.settings, console);
    if (!part.load(o.part)) {
        console.finish();
        return Exit::could_not_run;
    }
    const auto output = open_output(o);
    const RemovedOnInterrupt guard(output->temporary());
    const auto writer = form->make(part.job(), *output, o.form);
    Progress progress(*writer, output.get(), report::is_terminal(stderr));
    const passes::ExecuteResult result = part.run(progress, {.stop_after = {}, .stop = progress.stop()});
    const Exit found = console.outcome();
    // What is wrong leaves no file behind: an unfinished output removes itself.
    const bool whole = found == Exit::ok && output->finish();
    if (output->failure()) part.diagnostics().report(*output->failure());
    console.finish();
    if (o.statistics)
        print_statistics(part, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
                         result.blocks, progress.moves());
    if (whole && !o.settings.quiet && o.settings.format == "human")
        print_summary(o, part, progress.moves(), result.blocks);
    return output->failure() ? Exit::could_not_run : found;
}

}  // namespace

void add_compile(CLI::App& app, Exit& exit) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("compile", "Turn a program into the moves that the control would make");
    command->add_option("PART", options->part, "program file; - is standard input")->required();
    command->add_option("-o,--output", options->output, "result; its suffix chooses the form; - is standard output");
    add_form_options(*command, options->form, forms());
    command->add_flag("--stream", options->stream,
                      "standard output: moves as they come, even if an error follows them");
    add_program_options(*command, options->settings);
    command->add_flag("--stats", options->statistics, "blocks, shapes, parser calls and time on standard error")
        ->group("Diagnosis");
    command->footer(
        "Examples:\n"
        "  fagorc compile part.pit -o part.ftj\n"
        "  fagorc compile part.pit -o part.ngc --map\n"
        "  fagorc compile part.pit --to csv -o - --frame part\n"
        "  cat part.pit | fagorc compile - --machine lathe.toml -o part.ftj\n"
        "A program with errors leaves no output behind, neither a file nor text on standard output.");
    command->callback([options, &exit] { exit = compile(*options); });
}

}  // namespace fagorc::tool
