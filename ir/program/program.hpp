// A program as the executor reads it, and the library that programs call each other from.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ir/diag/diagnostic.hpp"
#include "ir/program/block.hpp"

namespace fagorc::program {

/// What the header line says (8055 T 1.1).
struct Header {
    std::string comment;
    bool present = false, oem = false, hidden = false, modifiable = true, executable = true;
};

/// A subroutine: the block after its (SUB n) or (LSUB n).
struct Subroutine {
    std::uint32_t number = 0;
    bool local = false;
    Cursor begin;  ///< the SUB block itself
    Cursor body;   ///< the block after it
};

/// The text in a slot of a block, without its quotes.
std::string_view text_of(const Block& block, std::uint16_t slot);

/// One program text. Blocks are decoded when they are read and never all kept; labels and subroutines are indexed when
/// the first jump or call asks. Implemented by frontend/structure.
class Program {
  public:
    virtual ~Program() = default;

    virtual diag::FileId file() const = 0;
    /// Number of the program in the control's memory, from its file name nnnnnn.PIT; nothing for other names.
    virtual std::optional<std::uint32_t> number() const = 0;
    virtual const Header& header() = 0;

    /// The first block of the text, behind the header line.
    virtual Cursor first() = 0;
    /// Where execution starts: after the header, and after the local subroutines and their `%` mark (8055 T 2.2).
    virtual Cursor start() = 0;
    /// The block at a cursor; null at the end of the text. It stays until the next read: no other question moves it.
    virtual const Block* read(Cursor at) = 0;
    /// The block again, decoded from a text made of it (`GP1` with the code put in). Null: the text has an error,
    /// which `out` has been told at the place of the original block.
    virtual const Block* rebind(const Block& original, std::string_view text, diag::Sink& out) = 0;

    /// The first block with this label; nothing where there is none (8055 T 2.1.1).
    virtual std::optional<Cursor> label(std::uint32_t number) = 0;
    virtual const Subroutine* subroutine(std::uint32_t number, bool local) = 0;

    /// Tokens of a block with their places, made again from its text.
    virtual std::vector<PlacedToken> tokens(const Block& block) = 0;
    /// The place of tokens [first, end) of a block.
    diag::Place place(const Block& block, std::uint32_t first, std::uint32_t end);
    diag::Place place(const Block& block);  ///< the whole block
    /// The place of a whole line, for findings of later passes that know only a line number.
    virtual diag::Place place_of_line(std::uint32_t line) = 0;
    /// The label (N) of the block on a line; nothing where it has none. Cheap for lines asked in their order.
    virtual std::optional<std::uint32_t> label_of_line(std::uint32_t line) = 0;

    /// Findings of all blocks that have not been read: a syntax error behind a jump is an error too.
    virtual void check_unread(diag::Sink& out) = 0;
    /// The text from `from` to its end, for the trajectory file. A reader that goes on piece by piece says so by `from`:
    /// what it has behind it may leave the memory until it is asked for again.
    virtual std::string_view text(std::size_t from = 0) = 0;
};

/// Programs by number, and global subroutines wherever they stand (8055 T 12.5).
class Library {
  public:
    virtual ~Library() = default;
    virtual Program* program(std::uint32_t number) = 0;
    struct Found {
        Program* program = nullptr;
        const Subroutine* subroutine = nullptr;
    };
    virtual Found subroutine(std::uint32_t number) = 0;
    /// (OPEN P..): a program made by the program. Fails when it exists and `append` says neither.
    enum class Opened { created, replaced, appended, exists };
    virtual Opened open(std::uint32_t number, std::optional<bool> append, std::string_view comment) = 0;
    /// (WRITE ..): a block more for the program opened last; false where none is open.
    virtual bool write(std::string_view block) = 0;
    virtual void close() = 0;
};

}  // namespace fagorc::program
