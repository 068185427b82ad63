// Programs of the customisation channel: what a file of screen and key statements must keep to (8055 T 12.9). They make
// no path, so they are checked as a text.
#pragma once

#include <set>
#include <string_view>

#include "passes/execute/session.hpp"

namespace fagorc::passes {

/// A program that holds a screen statement is a customisation program when no block of it has an axis word, M30 or M02
/// (the manual gives no mark, this is ours). Reads the program: the session's block must be read again.
bool is_customisation(program::Program& program);

/// Checks the blocks of a customisation program one after the other: no local parameters, constants of the screen
/// statements in their ranges, windows defined before they are written to.
class ScreenChecker {
  public:
    explicit ScreenChecker(Session& session) : session_(session) {}
    /// The session's block.
    void check();

  private:
    void check(const program::Statement& statement);
    void check(const program::Screen& screen);
    void check(const std::vector<program::Assignment>& list);
    void check(program::Expression expression);
    void window(double number, program::Expression operand, bool defines);
    std::optional<double> constant(program::Expression expression) const;
    void local(double parameter, std::uint16_t token);

    Session& session_;
    std::set<double> windows_;
    bool any_window_ = false;  ///< a window whose number is computed was defined: every number may be
};

}  // namespace fagorc::passes
