// fagorc compile: the main job, a program becomes the moves that the control would make.
#include <CLI/CLI.hpp>

#include <chrono>
#include <memory>
#include <string>

#include "backends/iso/iso.hpp"
#include "backends/output.hpp"
#include "backends/table/csv.hpp"
#include "backends/table/json.hpp"
#include "backends/trajectory/writer.hpp"
#include "tools/fagorc/commands.hpp"
#include "tools/fagorc/part.hpp"
#include "tools/fagorc/progress.hpp"
#include "tools/fagorc/report/language.hpp"

namespace fagorc::tool {
namespace {

struct Options {
    Settings settings;
    std::string part, output, form, frame = "machine";
    bool events = false, map = false;
};

/// A form of output: its name, the suffix that chooses it, and its writer.
struct Form {
    std::string_view name, suffixes;
    std::unique_ptr<operation::Sink> (*make)(const backends::Job&, backends::Output&, const Options&);
};

constexpr Form forms[] = {
    {"ftj", ".ftj",
     [](const backends::Job& j, backends::Output& o, const Options&) {
         return backends::make_trajectory_writer(j, o);
     }},
    {"iso", ".iso.nc.ngc.tap",
     [](const backends::Job& j, backends::Output& o, const Options& p) {
         return backends::make_iso_writer(j, o, {.map = p.map});
     }},
    {"csv", ".csv",
     [](const backends::Job& j, backends::Output& o, const Options& p) {
         return backends::make_csv_writer(j, o, {.part_frame = p.frame == "part", .events = p.events});
     }},
    {"json", ".json",
     [](const backends::Job& j, backends::Output& o, const Options&) { return backends::make_json_writer(j, o); }},
};

/// The form that `--to` names, else that of the output's suffix, else the trajectory file; null for an unknown suffix.
const Form* form_of(const Options& o) {
    const std::size_t dot = o.output.find_last_of("./");
    const bool has_suffix = dot != std::string::npos && o.output[dot] == '.' && dot + 1 < o.output.size();
    for (const Form& f : forms) {
        if (!o.form.empty() ? f.name == o.form : has_suffix && f.suffixes.find(o.output.substr(dot)) != f.suffixes.npos)
            return &f;
    }
    return o.form.empty() && !has_suffix ? &forms[0] : nullptr;
}

void print_statistics(Part& part, double seconds, std::uint64_t moves) {
    const frontend::Statistics s = part.workspace().statistics();
    std::fprintf(stderr,
                 "blocks %llu\nshapes %llu\nparser calls %llu\nmoves %llu\nseconds %.6f\nblocks per second %.0f\n",
                 static_cast<unsigned long long>(s.blocks), static_cast<unsigned long long>(s.shapes),
                 static_cast<unsigned long long>(s.parser_calls), static_cast<unsigned long long>(moves), seconds,
                 seconds > 0 ? static_cast<double>(s.blocks) / seconds : 0);
}

Exit compile(Options& o) {
    const auto begin = std::chrono::steady_clock::now();
    const Form* form = form_of(o);
    if (!form) {
        std::fprintf(stderr, "fagorc: no form of output ends in the suffix of %s; choose one with --to\n",
                     o.output.c_str());
        return Exit::could_not_run;
    }
    if (o.output.empty())
        o.output = o.part == "-" ? "-" : o.part.substr(0, o.part.find_last_of('.')) + "." + std::string(form->name);
    Console console(o.settings, stderr);
    Part part(o.settings, console);
    if (!part.load(o.part)) {
        console.finish();
        return Exit::could_not_run;
    }
    const auto output = o.output == "-" ? backends::open_standard_output() : backends::open_file(o.output);
    const auto writer = form->make(part.job(), *output, o);
    Progress progress(*writer, report::is_terminal(stderr));
    const passes::ExecuteResult result = part.run(progress, {});
    const Exit found = console.outcome();
    // What is wrong leaves no file behind: an unfinished output removes itself.
    if (found == Exit::ok && !output->finish()) part.diagnostics().report(*output->failure());
    const bool failed = output->failure().has_value();
    console.finish();
    if (o.settings.statistics)
        print_statistics(part, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
                         progress.moves());
    if (found == Exit::ok && !failed && !o.settings.quiet && o.settings.format == "human")
        std::fprintf(stderr, "%s -> %s: %llu moves of %llu blocks on the %s\n", o.part.c_str(), o.output.c_str(),
                     static_cast<unsigned long long>(progress.moves()), static_cast<unsigned long long>(result.blocks),
                     part.machine_name().c_str());
    return failed ? Exit::could_not_run : found;
}

}  // namespace

void add_compile(CLI::App& app, Exit& exit) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("compile", "Turn a program into the moves that the control would make");
    command->add_option("PART", options->part, "program file; - is standard input")->required();
    command->add_option("-o,--output", options->output, "result; its suffix chooses the form; - is standard output");
    command->add_option("--to", options->form, "form: ftj trajectory file, iso neutral RS-274, csv table, json lines")
        ->check(CLI::IsMember({"ftj", "iso", "csv", "json"}));
    command->add_option("--frame", options->frame, "csv: coordinates from the machine zero or the active part zero")
        ->check(CLI::IsMember({"machine", "part"}));
    command->add_flag("--events", options->events, "csv: rows for M functions, tools and messages too");
    command->add_flag("--map", options->map, "iso: comments that name the source block of each line");
    add_program_options(*command, options->settings);
    command->footer(
        "Examples:\n"
        "  fagorc compile part.pit -o part.ftj\n"
        "  fagorc compile part.pit -o part.ngc --map\n"
        "  fagorc compile part.pit --to csv -o - --frame part\n"
        "  cat part.pit | fagorc compile - --machine lathe.toml -o part.ftj\n"
        "A program with errors leaves no output behind.");
    command->callback([options, &exit] { exit = compile(*options); });
}

}  // namespace fagorc::tool
