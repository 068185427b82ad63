// The front end's whole surface: texts in, programs out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "ir/control/dialect.hpp"
#include "ir/diag/diagnostic.hpp"
#include "ir/program/program.hpp"

namespace fagorc::frontend {

struct Options {
    bool shape_cache = true;  ///< false: every block is parsed by ANTLR
    bool loop_cache = true;   ///< false: a block is decoded each time that a loop reads it
};

/// Counts for `--stats`.
struct Statistics {
    std::uint64_t blocks = 0, shapes = 0, parser_calls = 0;
};

/// Everything that a compilation reads: the main program, the library, the shapes that they share.
class Workspace {
  public:
    Workspace(const control::Dialect& dialect, diag::Sink& diagnostics, Options options = {});
    ~Workspace();

    /// Opens a file, or standard input for "-"; null when it cannot be read (reported).
    program::Program* open(const std::string& path);
    /// A program from memory, for tests and for programs made by OPEN and WRITE.
    program::Program& add(std::string name, std::string text);
    /// Makes the programs nnnnnn.PIT (or .PIM) of a folder available by number, and all their global subroutines. A
    /// number that a program has already keeps it; one with both endings is reported.
    bool add_library(const std::filesystem::path& folder);

    /// Gives a text that is no program (a machine file, a table of the control) a number for `name` and `line_at`.
    diag::FileId add_text(std::string name, std::string text);

    program::Library& library();
    /// The program of a file number; null for one that is no program.
    program::Program* program(diag::FileId file) const;
    Statistics statistics() const;

    /// For reporters: the name of a file and the text of the line that starts at an offset.
    std::string_view name(diag::FileId file) const;
    std::string_view line_at(diag::FileId file, std::uint64_t offset) const;

  private:
    class Counting;
    struct Implementation;
    std::unique_ptr<Implementation> implementation_;
};

}  // namespace fagorc::frontend
