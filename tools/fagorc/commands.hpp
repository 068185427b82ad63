// The subcommands: each adds itself, with its options and examples, and leaves its exit code when it has run.
#pragma once

#include "tools/fagorc/settings.hpp"

namespace fagorc::tool {

void add_compile(CLI::App& app, Exit& exit);
void add_check(CLI::App& app, Exit& exit);
void add_dump(CLI::App& app, Exit& exit);
void add_verify(CLI::App& app, Exit& exit);
void add_explain(CLI::App& app, Exit& exit);
/// Completions and the manual page are printed from the option tables of `app`.
void add_completions(CLI::App& app, Exit& exit);
void add_manual(CLI::App& app, Exit& exit);

}  // namespace fagorc::tool
