// fagorc dump: what a program looks like after each phase, and what a trajectory file holds.
#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <string>

#include "backends/output.hpp"
#include "backends/table/csv.hpp"
#include "frontend/scan/readable_key.hpp"
#include "frontend/scan/scanner.hpp"
#include "ir/operation/describe.hpp"
#include "ir/program/describe.hpp"
#include "tools/fagorc/commands.hpp"
#include "tools/fagorc/part.hpp"
#include "tools/fagorc/trajectory/file.hpp"
#include "tools/fagorc/trajectory/replay.hpp"
#include "tools/fagorc/trajectory/trajectory.hpp"

namespace fagorc::tool {
namespace {

struct Options {
    Settings settings;
    std::string part, stage, after, form, frame = "machine";
    bool events = false;
};

void print(const std::string& line) {
    std::fwrite(line.data(), 1, line.size(), stdout);
}

/// Prints operations as they arrive.
class Printer final : public operation::Sink {
  public:
    explicit Printer(const operation::Tables& tables) : tables_(tables) {}
    void push(const operation::Operation& o) override { print(operation::describe(o, tables_) + '\n'); }

  private:
    const operation::Tables& tables_;
};

/// One line a block: `show` says what of it.
template <class Show>
void print_blocks(Part& part, Show show) {
    program::Program& program = part.program();
    program::Cursor at = program.first();
    while (const program::Block* block = program.read(at)) {
        print(std::to_string(block->here.line) + ' ' + show(*block) + '\n');
        at = block->next;
    }
}

void print_syntax(Part& part) {
    const frontend::Scanner scanner(part.dialect());
    frontend::Scan scan(part.dialect().limits.block_bytes);
    print_blocks(part, [&](const program::Block& block) {
        scanner.scan(block.text.data(), scan);
        return frontend::readable_key(scan.key(), part.dialect());
    });
}

constexpr std::string_view trajectory_suffix = ".ftj";

/// A trajectory file as text, or its moves as a table.
Exit dump_file(const Options& o) {
    Console console(o.settings, stderr);
    const frontend::Workspace* no_programs = nullptr;
    diag::Sink& out = console.sink_of(no_programs);
    FileBytes file;
    if (!file.open(o.part, out)) {
        console.finish();
        return Exit::could_not_run;
    }
    const auto output = backends::open_standard_output();
    if (o.form.empty()) {
        dump_trajectory(o.part, file.bytes(), *output, out);
    } else if (verify_trajectory(o.part, file.bytes(), out)) {
        player::Trajectory trajectory;
        if (trajectory.open(file.bytes()) != player::Status::ok) return Exit::could_not_run;  // verified just before
        const Replay replay(trajectory);
        const backends::CsvOptions csv{.part_frame = o.frame == "part", .events = o.events};
        replay.run(*backends::make_csv_writer(replay.job(out), *output, csv));
    }
    if (!output->finish()) out.report(*output->failure());
    console.finish();
    return output->failure() ? Exit::could_not_run : console.outcome();
}

Exit dump(const Options& o) {
    if (o.part.ends_with(trajectory_suffix)) return dump_file(o);
    Console console(o.settings, stderr);
    Part part(o.settings, console);
    if (!part.load(o.part)) {
        console.finish();
        return Exit::could_not_run;
    }
    if (o.stage == "syntax") {
        print_syntax(part);
    } else if (o.stage == "program") {
        print_blocks(part, [&](const program::Block& b) { return program::describe(*b.shape, part.dialect()); });
    } else {
        Printer printer(part.tables());
        const std::string_view stop = !o.after.empty()          ? std::string_view(o.after)
                                      : o.stage == "operations" ? passes::Pipeline::before_all
                                                                : std::string_view{};
        part.run(printer, {stop, false});
    }
    if (o.stage == "syntax" || o.stage == "program") part.program().check_unread(part.diagnostics());
    console.finish();
    return console.outcome();
}

}  // namespace

void add_dump(CLI::App& app, Exit& exit) {
    auto options = std::make_shared<Options>();
    CLI::App* command = app.add_subcommand("dump", "Show a program after a phase, or what a trajectory file holds");
    command->add_option("PART", options->part, "program or .ftj file; - is a program on standard input")->required();
    auto* stage = command->add_option("--stage", options->stage, "syntax, program, operations or moves (default)")
                      ->check(CLI::IsMember({"syntax", "program", "operations", "moves"}));
    std::vector<std::string> names;
    for (std::string_view name : passes::Pipeline::names()) names.emplace_back(name);
    command->add_option("--after", options->after, "operations after a pass: " + CLI::detail::join(names, ", "))
        ->check(CLI::IsMember(names))
        ->excludes(stage);
    command->add_option("--to", options->form, ".ftj file: its moves as a csv table")->check(CLI::IsMember({"csv"}));
    command->add_option("--frame", options->frame, "csv: coordinates from the machine zero or the active part zero")
        ->check(CLI::IsMember({"machine", "part"}));
    command->add_flag("--events", options->events, "csv: rows for M functions, tools and messages too");
    add_program_options(*command, options->settings);
    command->footer(
        "Examples:\n"
        "  fagorc dump part.pit --stage syntax     shapes of the blocks\n"
        "  fagorc dump part.pit --after axes       operations in machine coordinates\n"
        "  fagorc dump part.ftj                    every block of a trajectory file\n"
        "  fagorc dump part.ftj --to csv           its moves as a table");
    command->callback([options, &exit] { exit = dump(*options); });
}

}  // namespace fagorc::tool
