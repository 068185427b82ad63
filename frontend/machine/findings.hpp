// Findings about a machine file: the places of its keys and values, and the texts that say what a key takes.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "frontend/machine/key.hpp"
#include "ir/diag/collection.hpp"

namespace fagorc::frontend::machine_file {

/// Where something stands in the file: line and column from 1, as the TOML reader counts (columns in characters).
struct Spot {
    std::uint32_t line = 0, column = 0, end_line = 0, end_column = 0;
};

/// Collects the findings of one file and hands them on in the order of their places.
class Findings {
  public:
    Findings(std::string_view text, diag::FileId file);

    template <class... Arguments>
    void report(diag::Id id, const Spot& spot, Arguments&&... arguments) {
        collected_.report(id, place(spot), std::forward<Arguments>(arguments)...);
    }
    bool any() const { return !collected_.list().empty(); }
    void hand_on(diag::Sink& to) const;

  private:
    diag::Place place(const Spot& spot) const;
    std::uint32_t byte_column(std::string_view line, std::uint32_t column) const;

    std::string_view text_;
    diag::FileId file_;
    std::vector<std::size_t> lines_;  ///< offset of each line's first byte
    diag::Collection collected_;
};

/// "0 .. 9", ">= 0", "> 0": the same in every language.
std::string range_text(const control::Range& range);
/// "mm, inch".
std::string choices_text(std::span<const std::string_view> choices);

}  // namespace fagorc::frontend::machine_file
