// Where lines and labels stand in a program: noted as far as a jump or call had to look.
#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "ir/program/block.hpp"

namespace fagorc::frontend {

/// Where lines start, about every `spacing`-th of them.
class LineTable {
  public:
    static constexpr std::uint32_t spacing = 256;
    void add(const program::Cursor& line) {
        if (line.line >= spacing * (starts_.size() + 1)) starts_.push_back(line);
    }
    /// The last line start known at or before `line`; `first` where none is.
    program::Cursor before(std::uint32_t line, const program::Cursor& first) const {
        for (std::size_t i = std::min<std::size_t>(line / spacing, starts_.size()); i-- > 0;)
            if (starts_[i].line <= line) return starts_[i];
        return first;
    }

  private:
    std::vector<program::Cursor> starts_;
};

/// Labels by number: 8 bytes each.
class LabelTable {
  public:
    /// Labels are added in the order of the text.
    void add(std::uint32_t label, std::uint32_t line);
    /// The line of the first block with the label (8055 T 2.1.1).
    std::optional<std::uint32_t> find(std::uint32_t label) const;

  private:
    struct Entry {
        std::uint32_t label, line;
    };
    std::vector<Entry> entries_;
    std::size_t sorted_ = 0;  ///< so many are in order of label, then of line; the few behind them in order of line
};

}  // namespace fagorc::frontend
