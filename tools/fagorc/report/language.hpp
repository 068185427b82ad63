// In which language, and in which colours, a run speaks.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <optional>
#include <string_view>

#include "ir/base/text.hpp"

namespace fagorc::report {

/// The language of a name that `--lang` takes ("en", "fr", "es"); nothing for another one.
std::optional<Language> language_of(std::string_view name);

/// Reads an environment variable: std::getenv, or a test's own.
using Environment = std::function<const char*(const char* name)>;

/// The language of the environment's locale: the first of LC_ALL, LC_MESSAGES and LANG that is set decides, as POSIX
/// says ("fr_FR.UTF-8", "es"); English for every other language.
Language language_of_environment(const Environment& environment);

/// What `--color` takes: always, never, auto.
enum class Color : std::uint8_t { automatic, always, never };
std::optional<Color> color_of(std::string_view name);

/// Whether to print colours: automatically only on a terminal that knows them, and not when NO_COLOR is set.
bool color_wanted(Color choice, bool on_terminal, const Environment& environment);

bool is_terminal(std::FILE* file);
/// Columns of the terminal of a file; nothing where it is no terminal.
std::optional<std::size_t> terminal_width(std::FILE* file);

}  // namespace fagorc::report
