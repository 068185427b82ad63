// Executes ISO blocks: modal state, words, functions, motion (docs/order.md).
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "passes/execute/session.hpp"

namespace fagorc::passes {

class IsoRunner {
  public:
    explicit IsoRunner(Session& session);
    ~IsoRunner();

    struct Outcome {
        bool moved = false;        ///< the block moved an axis: a modal subroutine follows
        bool program_end = false;  ///< M02 or M30
        /// Of an M or T function, or of G74 alone: called without a new level; then `subroutine_ended`.
        std::optional<std::uint32_t> subroutine;
    };
    /// Runs the session's block, whose body is an IsoBlock without codes by parameter.
    Outcome run(const program::IsoBlock& block);

    /// The subroutine that an outcome asked for has returned: an M function that waits for it is sent now. Until then
    /// the same function is executed without calling it again (8055 T 5.7). Answers the next subroutine of the same
    /// block, if there is one (T and M06 that have one each).
    std::optional<std::uint32_t> subroutine_ended();

    /// The general reset of M02, M30 (8055 T 5.7.3, 5.7.4).
    void reset();

    /// The modal state in force, e.g. the unit in which table variables are read and written.
    const program::Modal& modal() const;
    /// What program-state variables read; the value in active units, X by G151/G152 where `Role` says so.
    std::optional<double> variable(std::uint16_t row, int axis, std::optional<long> index);
    /// Writes a program-state variable (HTOR, DIAM); false for one that the runner does not keep.
    bool assign(std::uint16_t row, int axis, double value);
    /// Events of other statements (MSG, DGWZ ...) at the present place of the path.
    void push_event(operation::Event event);
    void push_barrier(operation::Barrier::Why why);
    /// ESBLK, DSTOP, DFHOLD and their opposites: part of the state of the moves that follow.
    void enable(program::Enable what);

    /// What the runner keeps; its parts are in iso_control.hpp, for the runner's own files.
    struct Control;

  private:
    std::unique_ptr<Control> control_;
};

}  // namespace fagorc::passes
