// One program text as the executor reads it: blocks decoded one by one, labels and subroutines on demand.
#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "frontend/scan/scanner.hpp"
#include "frontend/shape/cache.hpp"
#include "frontend/structure/index.hpp"
#include "frontend/structure/text.hpp"
#include "ir/control/dialect.hpp"
#include "ir/program/program.hpp"

namespace fagorc::frontend {

/// What the programs of a workspace share.
struct Decoder {
    const control::Dialect& dialect;
    const Scanner& scanner;
    ShapeCache& shapes;
    diag::Sink& diagnostics;
    bool loop_cache = true;  ///< keep decoded blocks once a program jumps back
};

class ProgramText final : public program::Program {
  public:
    ProgramText(const Decoder& decoder, diag::FileId file, std::string name, std::unique_ptr<Text> text);

    const std::string& name() const { return name_; }
    std::string_view line_at(std::uint64_t offset);
    std::uint64_t blocks_read() const { return blocks_read_; }

    diag::FileId file() const override { return file_; }
    std::optional<std::uint32_t> number() const override { return number_; }
    const program::Header& header() override;
    program::Cursor first() override;
    program::Cursor start() override;
    const program::Block* read(program::Cursor at) override;
    const program::Block* rebind(const program::Block& original, std::string_view text, diag::Sink& out) override;
    std::optional<program::Cursor> label(std::uint32_t number) override;
    const program::Subroutine* subroutine(std::uint32_t number, bool local) override;
    std::vector<program::PlacedToken> tokens(const program::Block& block) override;
    diag::Place place_of_line(std::uint32_t line) override;
    std::optional<std::uint32_t> label_of_line(std::uint32_t line) override;
    void check_unread(diag::Sink& out) override;
    std::string_view text(std::size_t from = 0) override { return text_->all(from); }

  private:
    /// A decoded block of a loop, by the cursor that it was asked for.
    struct Decoded {
        std::uint64_t asked = 0;
        program::Block block;
        std::vector<program::Quantity> slots;
    };
    static constexpr std::size_t loop_slots = 4096;
    /// The target of a recent jump.
    struct Target {
        std::uint32_t label = 0;
        std::optional<program::Cursor> at;
    };

    /// A block being read: what it needs until the next one.
    struct Reading {
        Scan scan;
        program::Block block;
        program::BlockTemplate shape;  ///< of this block alone: the cache does not keep it
    };
    const program::Block* decode(program::Cursor at, Reading& into);
    void refuse_label(Reading& reading) const;
    const program::Block* keep(program::Cursor asked);
    void read_start();
    bool is_mark(std::size_t offset);
    bool is_end_of_tape(program::Cursor at);
    program::Cursor line_after(program::Cursor at);
    program::Cursor cursor_of_line(std::uint32_t line);
    std::optional<program::Cursor> find_label(std::uint32_t number);
    const program::Block* index_next();
    void check_limits(const program::Block& block, diag::Sink& out);
    void check_subroutine(const program::Block& block, diag::Sink& out);

    Decoder decoder_;
    diag::FileId file_;
    std::string name_;
    std::optional<std::uint32_t> number_;
    std::unique_ptr<Text> text_;
    Reading reading_;  ///< of read()
    Reading looking_;  ///< of the index and the check, which leave the block that is executed alone
    Reading rebound_;
    Scan token_scan_;
    std::string rebound_text_;

    std::optional<program::Cursor> start_;
    program::Header header_;
    program::Cursor first_;    ///< behind the header line
    std::uint64_t mark_ = 0;   ///< offset of the line that starts the main part; start() where there is none
    program::Cursor read_to_;  ///< blocks from start() to here have been read in line
    std::uint64_t blocks_read_ = 0;
    std::vector<std::unique_ptr<Decoded>> loop_;  ///< decoded blocks by offset; empty until the program jumps back
    std::uint64_t furthest_ = 0;                  ///< behind the furthest block read

    program::Cursor indexed_to_;
    LabelTable labels_;
    LineTable lines_;
    std::array<Target, 64> targets_;  ///< by label: a loop jumps to the same few again and again
    std::map<std::pair<bool, std::uint32_t>, program::Subroutine> subroutines_;  ///< by local, number
    std::set<std::pair<bool, double>> seen_subroutines_;                         ///< by check_unread
    program::Cursor last_line_;  ///< of place_of_line: findings come in order
};

/// The number of a program from its file name nnnnnn.PIT or nnnnnn.PIM (8055 T 1.1).
std::optional<std::uint32_t> program_number(std::string_view path);

}  // namespace fagorc::frontend
