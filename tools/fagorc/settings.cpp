#include "tools/fagorc/settings.hpp"

#include <CLI/CLI.hpp>

namespace fagorc::tool {

void add_report_options(CLI::App& command, Settings& s) {
    command.add_option("--lang", s.language, "language of messages: en, fr, es (default: the locale)")
        ->check(CLI::IsMember({"en", "fr", "es"}))
        ->group("Messages");
    command.add_option("--color", s.color, "colours: auto, always, never; NO_COLOR is honoured")
        ->check(CLI::IsMember({"auto", "always", "never"}))
        ->group("Messages");
    command.add_option("--format", s.format, "findings as human, short, json (one object a line) or sarif")
        ->check(CLI::IsMember({"human", "short", "json", "sarif"}))
        ->group("Messages");
    command
        .add_option(
            "--max-errors", s.max_errors,
            "show so many findings and count the rest; 0: all (default: 200 for people, 25000 in sarif, else all)")
        ->group("Messages");
    command.add_flag("--deny-warnings", s.deny_warnings, "warnings count as errors for the exit code")
        ->group("Messages");
    command.add_flag("-q,--quiet", s.quiet, "no summary line")->group("Messages");
}

void add_program_options(CLI::App& command, Settings& s) {
    command.add_option("--control", s.control, "control that the program is written for (default: the machine's)")
        ->check(CLI::IsMember({"auto", "8055"}))
        ->group("Machine and program");
    command
        .add_option("--machine", s.machine_file, "machine file (docs/machine-file.md), laid over the built-in lathe")
        ->type_name("FILE")
        ->group("Machine and program");
    command.add_option("--tables", s.tables_folder, "folder of the control's own text tables: TO TLF TMZ ORG GUP")
        ->type_name("DIR")
        ->group("Machine and program");
    command.add_option("--library", s.libraries, "folder of programs nnnnnn.PIT that programs call; may be repeated")
        ->type_name("DIR")
        ->group("Machine and program");
    command.add_option("--set", s.values, "value of a variable that only the machine knows; may be repeated")
        ->type_name("NAME=VALUE")
        ->group("Machine and program");
    command.add_option("--skip", s.skip, "block skip marks that are set, e.g. 1,3")
        ->delimiter(',')
        ->check(CLI::Range(1, 3))
        ->group("Machine and program");
    command.add_option("--max-blocks", s.max_blocks, "stop after so many executed blocks")
        ->group("Machine and program");
    command.add_flag("--verify-passes", s.verify_passes, "check what must hold between the passes")->group("Diagnosis");
    command.add_flag("--no-shape-cache", s.no_shape_cache, "parse every block anew")->group("Diagnosis");
    command.add_flag("--no-loop-cache", s.no_loop_cache, "decode the blocks of loops anew")->group("Diagnosis");
    add_report_options(command, s);
}

}  // namespace fagorc::tool
