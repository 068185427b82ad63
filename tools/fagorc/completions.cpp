// fagorc completions: what a shell needs to complete the command line, from the option tables.
#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <string>

#include "tools/fagorc/commands.hpp"
#include "tools/fagorc/option_tables.hpp"

namespace fagorc::tool {
namespace {

std::string all_names(const CommandRow& command) {
    std::string names;
    for (const OptionRow& o : command.options)
        for (const std::string& n : o.names) names += ' ' + n;
    return names;
}

/// Text between single quotes of a shell.
std::string quoted(std::string text) {
    for (std::size_t i = 0; (i = text.find('\'', i)) != text.npos; i += 4) text.replace(i, 1, "'\\''");
    return text;
}

std::string bash(const std::vector<CommandRow>& rows) {
    std::string commands, options, values;
    for (const CommandRow& c : rows) {
        if (!c.name.empty()) commands += ' ' + c.name;
        if (!c.name.empty()) options += fmt::format("        {}) words='{}' ;;\n", c.name, all_names(c).substr(1));
        for (const OptionRow& o : c.options)
            if (!o.choices.empty() && !c.name.empty())
                values += fmt::format("        {}:{}) COMPREPLY=($(compgen -W '{}' -- \"$cur\")); return ;;\n", c.name,
                                      o.names.front(), fmt::join(o.choices, " "));
    }
    return fmt::format(R"(_fagorc() {{
    local cur=${{COMP_WORDS[COMP_CWORD]}} prev=${{COMP_WORDS[COMP_CWORD-1]}} command=${{COMP_WORDS[1]}} words=''
    COMPREPLY=()
    if [ "$COMP_CWORD" -eq 1 ]; then COMPREPLY=($(compgen -W '{}{}' -- "$cur")); return; fi
    case "$command:$prev" in
{}    esac
    case "$command" in
{}    esac
    case "$cur" in
        -*) COMPREPLY=($(compgen -W "$words" -- "$cur")) ;;
        *) COMPREPLY=($(compgen -f -- "$cur")) ;;
    esac
}}
complete -o filenames -F _fagorc fagorc
)",
                       commands.substr(1), all_names(rows.front()), values, options);
}

std::string zsh(const std::vector<CommandRow>& rows) {
    std::string commands, cases;
    for (const CommandRow& c : rows) {
        if (c.name.empty()) continue;
        commands += fmt::format(" '{}:{}'", c.name, quoted(c.description));
        cases += fmt::format("        {}) _arguments", c.name);
        for (const OptionRow& o : c.options) {
            std::string description;
            for (char ch : quoted(o.description))
                description += std::string(ch == '[' || ch == ']' || ch == ':' ? "\\" : "") + ch;
            const std::string value = o.value.empty()     ? ""
                                      : o.choices.empty() ? ":value:_files"
                                                          : fmt::format(":value:({})", fmt::join(o.choices, " "));
            for (const std::string& n : o.names) cases += fmt::format(" '*{}[{}]{}'", n, description, value);
        }
        cases += " '*:file:_files' ;;\n";
    }
    return fmt::format(R"(#compdef fagorc
_fagorc() {{
    local -a commands
    commands=({})
    if (( CURRENT == 2 )); then _describe 'command' commands; return; fi
    case "$words[2]" in
{}    esac
}}
_fagorc "$@"
)",
                       commands.substr(1), cases);
}

std::string fish(const std::vector<CommandRow>& rows) {
    std::string out;
    for (const CommandRow& c : rows) {
        if (c.name.empty()) continue;
        out +=
            fmt::format("complete -c fagorc -n __fish_use_subcommand -a {} -d '{}'\n", c.name, quoted(c.description));
        for (const OptionRow& o : c.options) {
            out += fmt::format("complete -c fagorc -n '__fish_seen_subcommand_from {}'", c.name);
            for (const std::string& n : o.names)
                out += n.starts_with("--") ? " -l " + n.substr(2) : " -s " + n.substr(1);
            if (!o.choices.empty())
                out += fmt::format(" -xa '{}'", fmt::join(o.choices, " "));
            else if (!o.value.empty())
                out += " -r";
            out += fmt::format(" -d '{}'\n", quoted(o.description));
        }
    }
    return out;
}

}  // namespace

void add_completions(CLI::App& app, Exit& exit) {
    auto shell = std::make_shared<std::string>();
    CLI::App* command = app.add_subcommand("completions", "Print completions for a shell");
    command->add_option("SHELL", *shell, "bash, zsh or fish")
        ->required()
        ->check(CLI::IsMember({"bash", "zsh", "fish"}));
    command->footer(
        "Examples:\n"
        "  fagorc completions bash > /etc/bash_completion.d/fagorc\n"
        "  fagorc completions fish > ~/.config/fish/completions/fagorc.fish");
    command->callback([&app, shell, &exit] {
        const auto rows = option_tables(app);
        const std::string text = *shell == "bash" ? bash(rows) : *shell == "zsh" ? zsh(rows) : fish(rows);
        std::fwrite(text.data(), 1, text.size(), stdout);
        exit = Exit::ok;
    });
}

}  // namespace fagorc::tool
