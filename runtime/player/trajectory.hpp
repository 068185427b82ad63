// A trajectory file in memory (loaded, mapped, or received): opened, searched, read. It allocates nothing and throws
// nothing; the bytes must outlive it.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "runtime/player/blocks.hpp"
#include "runtime/player/records.hpp"

namespace fagorc::player {

/// A program whose text stands in the file.
struct Program {
    std::string_view name;
    std::uint64_t size = 0;  ///< bytes of its text
};

class Trajectory {
  public:
    /// Looks at the header and at the index at the end. Where there is no whole index, all blocks are walked and their
    /// hashes checked, and what comes before the first bad one can be read: `truncated` or `damaged`.
    /// After `ok`, call `verify` (verify.hpp) before the moves are trusted.
    Status open(Bytes file);

    std::uint64_t moves() const { return moves_; }
    std::uint64_t events() const { return events_; }
    std::uint32_t states() const { return states_; }
    std::uint32_t chains() const { return chains_; }
    std::uint32_t texts() const { return texts_; }
    std::uint32_t programs() const { return programs_; }
    /// Whole blocks.
    std::uint64_t blocks() const { return blocks_; }
    /// The program reached its end: M30, M02 or the end of its text.
    bool completed() const { return completed_; }
    /// INDEX and END are there.
    bool indexed() const { return index_.has_value(); }

    /// Blocks in the order of the file: the first one, and the one after another; nothing at the end.
    std::optional<Block> first_block() const { return block_in(file_header_size); }
    std::optional<Block> next_block(const Block& block) const { return block_in(block.next); }

    /// The well-formed block that holds record `n` of a type; nothing where there is none.
    std::optional<Block> find(Type type, std::uint64_t n) const;
    /// The block of moves, plain or wide, that holds move `n`.
    std::optional<Block> find_move(std::uint64_t n) const;

    std::optional<State> state(std::uint32_t n) const;
    std::optional<Chain> chain(std::uint32_t n) const;
    std::optional<Event> event(std::uint64_t n) const;
    std::optional<Tool> tool(std::uint64_t n) const;
    /// The first event that does not come before an earlier move than `move`; `events()` where there is none.
    std::uint64_t first_event_before(std::uint64_t move) const;
    /// A message, its bytes as the program holds them.
    std::string_view text(std::uint32_t n) const;
    /// The JSON text about the compilation.
    std::string_view meta() const;

    std::optional<Program> program(std::uint32_t n) const;
    /// The piece of a program's text that begins at a byte; empty at its end. The pieces follow each other.
    std::string_view source(std::uint32_t program, std::uint64_t at) const;

    Bytes file() const { return file_; }

  private:
    std::optional<Block> block_in(std::uint64_t offset) const;
    std::optional<Block> find_by_index(Type type, std::uint64_t n) const;
    std::optional<Block> find_by_walking(Type type, std::uint64_t n) const;
    std::optional<Block> find_source(std::uint32_t program, std::uint64_t at) const;
    const std::byte* find_record(Type type, std::uint64_t n) const;
    Status open_indexed();
    Status walk();
    void count(const Block& block);

    Bytes file_;
    std::uint64_t end_ = 0;  ///< bytes of whole blocks
    std::uint64_t blocks_ = 0, moves_ = 0, events_ = 0;
    std::uint32_t states_ = 0, chains_ = 0, texts_ = 0, programs_ = 0;
    bool completed_ = false;
    std::optional<Block> index_;
};

}  // namespace fagorc::player
