// Values that only the running machine knows.
#pragma once

#include <optional>
#include <string_view>

namespace fagorc::program {

/// Answers for a live variable by its full name as a program writes it without blanks: "POSX", "PLCI12", "TIMER".
class LiveValues {
  public:
    virtual ~LiveValues() = default;
    /// Nothing where nobody knows: the compiler never guesses.
    virtual std::optional<double> value(std::string_view name) = 0;
};

}  // namespace fagorc::program
