// The forms of output that moves are printed in, for `compile` and for `dump` of a trajectory file.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "backends/backend.hpp"
#include "backends/output.hpp"

namespace CLI {
class App;
}

namespace fagorc::tool {

/// What the text forms leave to the user.
struct FormOptions {
    std::string form;               ///< --to; empty: not said
    std::string frame = "machine";  ///< csv: machine | part
    bool events = false;            ///< csv and iso: not only motion
    bool map = false;               ///< iso: comments that name the source blocks
};

/// A form of output: its name, the suffixes of files that choose it, what it is, and its writer.
struct Form {
    std::string_view name, suffixes, title;
    std::unique_ptr<operation::Sink> (*make)(const backends::Job&, backends::Output&, const FormOptions&);
};

/// All forms; the trajectory file is the first.
std::span<const Form> forms();
/// The form of a name; null for an unknown one.
const Form* form_named(std::string_view name);
/// The form that a file's suffix chooses; the trajectory file where it has none; null for an unknown one.
const Form* form_of_file(std::string_view path);

/// So many bytes, a million moves, wait for the end of a run; what is longer is passed on, so that a program without
/// an end neither fills the disk nor keeps its reader waiting.
inline constexpr std::uint64_t most_held_back = std::uint64_t{64} << 20;

/// Adds `--to` with those of the forms, `--frame`, `--events` and `--map`.
void add_form_options(CLI::App& command, FormOptions& options, std::span<const Form> to);

}  // namespace fagorc::tool
