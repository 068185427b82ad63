#include "tools/fagorc/option_tables.hpp"

#include <CLI/CLI.hpp>

namespace fagorc::tool {
namespace {

/// The members of a list that CLI11 writes as {a,b,c} into an option's type name.
std::vector<std::string> choices_of(const std::string& type) {
    const std::size_t open = type.find('{'), close = type.find('}');
    if (open == type.npos || close == type.npos) return {};
    return CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
}

CommandRow row_of(const CLI::App& app) {
    CommandRow row{app.get_parent() ? app.get_name() : "", app.get_description(), app.get_footer(), {}, {}};
    for (const CLI::Option* o : app.get_options()) {
        if (o->get_positional()) {
            row.positionals.push_back(o->get_name(true));
            continue;
        }
        OptionRow option{{}, "", o->get_description(), choices_of(o->get_type_name())};
        for (const std::string& n : o->get_lnames()) option.names.push_back("--" + n);
        for (const std::string& n : o->get_snames()) option.names.push_back("-" + n);
        if (o->get_items_expected_max() > 0)
            option.value = option.choices.empty() ? o->get_type_name() : CLI::detail::join(option.choices, "|");
        row.options.push_back(std::move(option));
    }
    return row;
}

}  // namespace

std::vector<CommandRow> option_tables(const CLI::App& app) {
    std::vector<CommandRow> rows{row_of(app)};
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
        rows.push_back(row_of(*command));
    return rows;
}

}  // namespace fagorc::tool
