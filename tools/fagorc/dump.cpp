// fagorc dump: what a program looks like after each phase, and what a trajectory file holds.
#include <CLI/CLI.hpp>

#include <cstdio>
#include <memory>
#include <string>

#include "backends/output.hpp"
#include "backends/text.hpp"
#include "frontend/scan/readable_key.hpp"
#include "frontend/scan/scanner.hpp"
#include "ir/operation/describe.hpp"
#include "ir/program/describe.hpp"
#include "tools/fagorc/commands.hpp"
#include "tools/fagorc/form.hpp"
#include "tools/fagorc/part.hpp"
#include "tools/fagorc/progress.hpp"
#include "tools/fagorc/report/language.hpp"
#include "tools/fagorc/trajectory/file.hpp"
#include "tools/fagorc/trajectory/replay.hpp"
#include "tools/fagorc/trajectory/trajectory.hpp"

namespace fagorc::tool {
namespace {

struct Options {
    Settings settings;
    FormOptions form;
    std::string part, stage, after;
};

/// Prints operations as they arrive.
class Printer final : public operation::Sink {
  public:
    Printer(const operation::Tables& tables, backends::TextWriter& out) : tables_(tables), out_(out) {}
    void push(const operation::Operation& o) override {
        out_.text += operation::describe(o, tables_);
        out_.end_line();
    }

  private:
    const operation::Tables& tables_;
    backends::TextWriter& out_;
};

/// One line a block: `show` says what of it.
template <class Show>
void print_blocks(Part& part, backends::TextWriter& out, Show show) {
    program::Program& program = part.program();
    program::Cursor at = program.first();
    while (const program::Block* block = program.read(at)) {
        backends::append_whole(out.text, block->here.line);
        (out.text += ' ') += show(*block);
        out.end_line();
        at = block->next;
    }
}

void print_syntax(Part& part, backends::TextWriter& out) {
    const frontend::Scanner scanner(part.dialect());
    frontend::Scan scan(part.dialect().limits.block_bytes);
    print_blocks(part, out, [&](const program::Block& block) {
        scanner.scan(block.text.data(), scan);
        return frontend::readable_key(scan.key(), part.dialect());
    });
}

void print_operations(const Options& o, Part& part, backends::TextWriter& text, const backends::Output& output) {
    Printer printer(part.tables(), text);
    Progress progress(printer, &output, false);
    const std::string_view stop_after = !o.after.empty()          ? std::string_view(o.after)
                                        : o.stage == "operations" ? passes::Pipeline::before_all
                                                                  : std::string_view{};
    part.run(progress, {.stop_after = stop_after, .stop = progress.stop()});
}

/// The exit code once everything is printed: what could not be printed is a finding.
Exit end(backends::Output& output, diag::Sink& out, Console& console) {
    if (!output.finish()) out.report(*output.failure());
    console.finish();
    return output.failure() ? Exit::could_not_run : console.outcome();
}

/// The moves of a sound trajectory file in the form that is asked for; nothing of another file.
Exit print_moves(const Options& o, player::Bytes file, Console& console, diag::Sink& out) {
    player::Trajectory trajectory;
    if (!verify_trajectory(o.part, file, out) || trajectory.open(file) != player::Status::ok) {
        console.finish();
        return console.outcome();
    }
    const auto output = backends::open_held_standard_output(most_held_back);
    const Replay replay(trajectory);
    const auto writer = form_named(o.form.form)->make(replay.job(out), *output, o.form);
    Progress progress(*writer, output.get(), report::is_terminal(stderr));
    replay.run(progress, progress.stop());
    if (console.outcome() == Exit::ok) return end(*output, out, console);
    console.finish();
    return console.outcome();
}

/// A trajectory file: all that it holds, or its moves.
Exit dump_file(const Options& o) {
    Console console(o.settings, stderr);
    const frontend::Workspace* no_programs = nullptr;
    diag::Sink& out = console.sink_of(no_programs);
    FileBytes file;
    if (!file.open(o.part, out)) {
        console.finish();
        return Exit::could_not_run;
    }
    if (!o.form.form.empty()) return print_moves(o, file.bytes(), console, out);
    const auto output = backends::open_standard_output();
    dump_trajectory(o.part, file.bytes(), *output, out);
    return end(*output, out, console);
}

constexpr std::string_view trajectory_suffix = ".ftj";

Exit dump(const Options& o) {
    if (o.part.ends_with(trajectory_suffix)) return dump_file(o);
    if (!o.form.form.empty()) {
        std::fprintf(stderr, "fagorc: --to is for .ftj files; fagorc compile prints the moves of a program\n");
        return Exit::could_not_run;
    }
    Console console(o.settings, stderr);
    Part part(o.settings, console);
    if (!part.load(o.part)) {
        console.finish();
        return Exit::could_not_run;
    }
    const auto output = backends::open_standard_output();
    backends::TextWriter text(*output);
    if (o.stage == "syntax")
        print_syntax(part, text);
    else if (o.stage == "program")
        print_blocks(part, text, [&](const program::Block& b) { return program::describe(*b.shape, part.dialect()); });
    else
        print_operations(o, part, text, *output);
    text.flush();
    if (o.stage == "syntax" || o.stage == "program") part.program().check_unread(part.diagnostics());
    return end(*output, part.diagnostics(), console);
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
    add_form_options(*command, options->form, forms().subspan(1));
    add_program_options(*command, options->settings);
    command->footer(
        "Examples:\n"
        "  fagorc dump part.pit --stage syntax     shapes of the blocks\n"
        "  fagorc dump part.pit --after axes       operations in machine coordinates\n"
        "  fagorc dump part.ftj                    every block of a trajectory file\n"
        "  fagorc dump part.ftj --to csv           its moves as a table, as compile --to csv prints it");
    command->callback([options, &exit] { exit = dump(*options); });
}

}  // namespace fagorc::tool
