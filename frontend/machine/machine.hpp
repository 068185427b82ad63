// Machines: the built-in lathe, the machine file laid over it, the control's own text tables (docs/machine-file.md).
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "ir/control/dialect.hpp"
#include "ir/diag/diagnostic.hpp"
#include "ir/machine/machine.hpp"

namespace fagorc::frontend {

/// The machine that is used when no machine file is given: everything is there, nothing is limited, so that a sound
/// program of any lathe of this control checks clean.
machine::Machine built_in_lathe(const control::Dialect& dialect);

/// Lays the TOML text of a machine file over `base`. `name` is the file as the user wrote it, `file` its number in
/// findings. Any error is reported with its place and nothing is returned, so that no half of a file is ever applied.
std::optional<machine::Machine> read_machine_file(std::string_view text, std::string_view name, diag::FileId file,
                                                  const machine::Machine& base, diag::Sink& diagnostics);

/// Gives a text a file number, so that findings can point into it and reporters can show its lines.
using Register = std::function<diag::FileId(std::string name, std::string text)>;

/// Reads the control's own text tables of a folder into `machine`: TO (offsets), TLF (tools), TMZ (magazine), ORG (zero
/// offsets), GUP (global parameters). A table that is there replaces the rows that it lists; others of the control's
/// tables (MPG, AUM ...) are left alone. False when a table is wrong (reported); `machine` is unchanged then.
bool read_control_tables(const std::filesystem::path& folder, machine::Machine& machine, const Register& add,
                         diag::Sink& diagnostics);

}  // namespace fagorc::frontend
