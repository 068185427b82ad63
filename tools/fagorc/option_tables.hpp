// The option tables as completions and the manual page read them: one truth with --help.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace fagorc::tool {

struct OptionRow {
    std::vector<std::string> names;    ///< "--to", "-o"; empty for a positional one
    std::string value, description;    ///< what it takes, empty for a flag
    std::vector<std::string> choices;  ///< allowed values, where they are listed
};

struct CommandRow {
    std::string name, description, examples;
    std::vector<std::string> positionals;
    std::vector<OptionRow> options;
};

/// The subcommands in their order; the first row, without a name, is the program itself.
std::vector<CommandRow> option_tables(const CLI::App& app);

}  // namespace fagorc::tool
