// Where labels and subroutines stand in a program: made on the first jump or call, from the start of the text.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "ir/program/program.hpp"

namespace fagorc::frontend {

/// Where lines start, every `spacing`-th of them.
class LineTable {
  public:
    static constexpr std::uint32_t spacing = 256;
    void add(const program::Cursor& line) {
        if (line.line >= spacing * (starts_.size() + 1)) starts_.push_back(line);
    }
    /// The last line start known at or before `line`; `first` where none is.
    program::Cursor before(std::uint32_t line, const program::Cursor& first) const {
        const std::size_t n = line / spacing;
        const std::size_t i = n < starts_.size() ? n : starts_.size();
        for (std::size_t k = i; k-- > 0;)
            if (starts_[k].line <= line) return starts_[k];
        return first;
    }

  private:
    std::vector<program::Cursor> starts_;
};

/// Labels by number: 8 bytes each.
class LabelTable {
  public:
    void add(std::uint32_t label, std::uint32_t line) {
        if (!entries_.empty() && label <= entries_.back().label) sorted_ = false;
        entries_.push_back({label, line});
    }
    /// The line of the first block with the label.
    std::optional<std::uint32_t> find(std::uint32_t label);

  private:
    struct Entry {
        std::uint32_t label, line;
    };
    std::vector<Entry> entries_;
    bool sorted_ = true;  ///< by label, equal ones by line
};

/// Subroutines in the order of the text, with the line of the block that ends each.
struct SubroutineEntry {
    program::Subroutine subroutine;
    std::uint32_t end_line = 0;  ///< of its RET; 0 while none was found
};

}  // namespace fagorc::frontend
