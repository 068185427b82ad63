// fagorc manual: the manual page, from the option tables.
#include <CLI/CLI.hpp>

#include <fmt/format.h>

#include <cstdio>
#include <string>

#include "tools/fagorc/commands.hpp"
#include "tools/fagorc/option_tables.hpp"
#include "tools/fagorc/version.hpp"

namespace fagorc::tool {
namespace {

/// Text for roff: backslashes, dashes and leading dots are its own characters.
std::string roff(std::string_view text) {
    std::string out;
    for (char c : text) {
        if (c == '\\')
            out += "\\e";
        else if (c == '-')
            out += "\\-";
        else if ((c == '.' || c == '\'') && (out.empty() || out.back() == '\n'))
            out += std::string("\\&") + c;
        else
            out += c;
    }
    return out;
}

std::string section(const CommandRow& c) {
    std::string text = fmt::format(".SS fagorc {} {}\n{}.\n", roff(c.name),
                                   roff(fmt::format("{}", fmt::join(c.positionals, " "))), roff(c.description));
    for (const OptionRow& o : c.options)
        text += fmt::format(".TP\n\\fB{}\\fR{}\n{}\n", roff(fmt::format("{}", fmt::join(o.names, ", "))),
                            o.value.empty() ? "" : " \\fI" + roff(o.value) + "\\fR", roff(o.description));
    if (!c.examples.empty()) text += ".PP\n.nf\n" + roff(c.examples) + "\n.fi\n";
    return text;
}

std::string page(const std::vector<CommandRow>& rows) {
    std::string text = fmt::format(
        ".TH FAGORC 1 \"\" \"fagorc {}\" \"User commands\"\n.SH NAME\nfagorc \\- {}\n.SH SYNOPSIS\n\\fBfagorc\\fR "
        "\\fIcommand\\fR [\\fIoptions\\fR] \\fIfile\\fR ...\n.SH COMMANDS\n",
        version, roff(rows.front().description));
    for (std::size_t i = 1; i < rows.size(); ++i) text += section(rows[i]);
    text +=
        ".SH EXIT STATUS\n0: no error. 1: errors found. 2: could not run.\n"
        ".SH ENVIRONMENT\nLC_ALL, LC_MESSAGES, LANG: language of messages. NO_COLOR: no colours. TMPDIR: where "
        "standard "
        "input is kept while it is read.\n";
    return text;
}

}  // namespace

void add_manual(CLI::App& app, Exit& exit) {
    CLI::App* command = app.add_subcommand("manual", "Print the manual page");
    command->footer("Examples:\n  fagorc manual > /usr/local/share/man/man1/fagorc.1\n  fagorc manual | man -l -");
    command->callback([&app, &exit] {
        const std::string text = page(option_tables(app));
        std::fwrite(text.data(), 1, text.size(), stdout);
        exit = Exit::ok;
    });
}

}  // namespace fagorc::tool
