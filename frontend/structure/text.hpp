// The bytes of a program: a file in memory, or standard input kept in a temporary file while it is read.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "ir/diag/diagnostic.hpp"

namespace fagorc::frontend {

/// One contiguous text. A line end stands behind its last byte in memory, so that a scanner needs no end check.
class Text {
  public:
    virtual ~Text() = default;

    const char* data() const { return data_; }
    /// Blocks that start before this offset are whole.
    std::size_t ready() const { return ready_; }
    /// Waits until the block at `offset` is whole; false when the text ends before it.
    bool reach(std::size_t offset) { return offset < ready_ || more(offset); }
    /// Everything from `from` up to the end of the input; what lies before may leave the memory until it is read again.
    std::string_view all(std::size_t from = 0) {
        while (more(ready_)) {
        }
        leave(from);
        return {data_ + from, ready_ - from};
    }
    /// Whether the end of the input has been seen.
    bool complete() const { return complete_; }
    /// Why the input ends before its end, where that happened: told once.
    std::optional<diag::Diagnostic> take_failure() { return std::exchange(failure_, std::nullopt); }

    /// What the texts of a program share: a byte order mark, control characters at the end and line ends.
    static std::size_t without_tail(std::string_view text);

  protected:
    virtual bool more(std::size_t) { return false; }
    /// A reader of the whole text has come to `offset`.
    virtual void leave(std::size_t) {}
    const char* data_ = nullptr;
    std::size_t ready_ = 0;
    bool complete_ = true;
    std::optional<diag::Diagnostic> failure_;
};

/// A text from memory.
std::unique_ptr<Text> text_of(std::string_view text);
/// A regular file, read whole: it may shrink or change on disk without harm. What is no regular file (a named pipe, a
/// device) is read as a stream. Null: reported.
std::unique_ptr<Text> text_of_file(const std::string& path, diag::Sink& out);
/// A pipe or terminal, kept in an unlinked temporary file as it is read, so that jumps back find it: blocks are ready
/// before the input ends, and memory stays constant. Of a block beyond all measure only the beginning is kept, and an
/// input without line ends is given up. Owns the descriptor; `out` outlives the text. Null: reported. `name` is for
/// findings.
std::unique_ptr<Text> text_of_stream(int descriptor, std::string name, diag::Sink& out);

/// Whether the first bytes of a file may belong to a program; reports what no program holds: the byte order mark of
/// UTF-16, or control characters all over.
bool is_program_text(std::string_view head, diag::Sink& out);

}  // namespace fagorc::frontend
