// The words of a control's high-level language, found by longest prefix (8055 T 11.1: blanks between words are
// optional).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "ir/control/dialect.hpp"

namespace fagorc::frontend {

/// A trie over reserved words and variable names; the names of an axis family are its root with each axis letter.
class Lexicon {
  public:
    explicit Lexicon(const control::Dialect& dialect);

    struct Word {
        program::Token token{};
        std::uint16_t payload = 0;
        bool text_follows = false;
        std::uint16_t length = 0;  ///< 0: no word starts here
    };
    /// The longest word at the start of `text`, which ends in a character of no word. Letters count in upper case.
    Word longest(const char* text) const;

  private:
    static constexpr std::size_t symbols = 36;  ///< A..Z 0..9
    struct Node {
        std::array<std::uint16_t, symbols> next{};
        Word word;
    };
    void add(std::string_view name, Word word);

    std::vector<Node> nodes_;
};

}  // namespace fagorc::frontend
