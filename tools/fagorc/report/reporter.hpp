// Reporters: how findings are printed. Each is a sink that prints as findings come, or, for SARIF, when all have come.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "ir/base/text.hpp"
#include "ir/diag/collection.hpp"
#include "ir/diag/diagnostic.hpp"

namespace fagorc::report {

/// Names and lines of the files that findings point into.
class SourceTexts {
  public:
    virtual ~SourceTexts() = default;
    virtual std::string_view name(diag::FileId file) const = 0;
    /// The line that starts at a byte offset, without its line end; empty where it is not at hand.
    virtual std::string_view line_at(diag::FileId file, std::uint64_t offset) const = 0;
};

enum class Format : std::uint8_t { human, brief, json, sarif };

/// The format of a name that `--format` takes: human, short, json, sarif.
std::optional<Format> format_of(std::string_view name);

struct Options {
    Language language = Language::english;
    std::string control = "8055";  ///< whose alarm numbers are shown
    std::string version;           ///< of the program, for SARIF
    bool color = false;
    std::size_t width = 100;  ///< columns of the terminal: longer lines are cut around the caret
};

/// Takes printed text; the receiver sees to the file, its errors and a closed pipe.
using Write = std::function<void(std::string_view)>;

class Reporter : public diag::Sink {
  public:
    using Sink::report;
    /// All findings have come: a summary for people, the whole document for SARIF. `left_out` findings were not passed.
    virtual void finish(const diag::Counts& counts, std::uint64_t left_out) = 0;
};

/// A reporter that reads names and lines from `texts`, which must outlive it.
std::unique_ptr<Reporter> make_reporter(Format format, Write write, const SourceTexts& texts, Options options);

}  // namespace fagorc::report
