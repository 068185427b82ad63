// The options that all subcommands share.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace fagorc::tool {

/// Exit codes of every subcommand.
enum Exit : int { ok = 0, errors_found = 1, could_not_run = 2 };

struct Settings {
    std::string control = "auto";
    std::string machine_file, tables_folder;
    std::vector<std::string> libraries, values;
    std::vector<int> skip;  ///< block skip marks that are set, 1..3
    std::string language, color = "auto", format = "human";
    std::optional<std::uint64_t> max_errors;  ///< findings that are shown; 0: all
    std::uint64_t max_blocks = 1'000'000'000;
    bool deny_warnings = false, quiet = false, verify_passes = false;
    bool no_shape_cache = false, no_loop_cache = false;
};

/// Adds the options that say how a finding is shown.
void add_report_options(CLI::App& command, Settings& settings);
/// Adds those and the options that say how a program is run.
void add_program_options(CLI::App& command, Settings& settings);

}  // namespace fagorc::tool
