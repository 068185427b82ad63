// Runs a program as the control would and pushes the operations that it makes (8055 T 5, 12; docs/order.md).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "ir/control/dialect.hpp"
#include "ir/machine/machine.hpp"
#include "ir/operation/operation.hpp"
#include "ir/program/live.hpp"
#include "ir/program/program.hpp"

namespace fagorc::passes {

struct ExecuteOptions {
    std::uint8_t skip_marks = 0;               ///< bit 0..2: BLKSKIP1..3 are set
    std::uint64_t max_blocks = 1'000'000'000;  ///< fuel: a run that reads more blocks is stopped with a diagnostic
    /// A run of so many blocks without a move is taken for an endless loop: hours of the control's time.
    std::uint64_t max_blocks_without_motion = 20'000'000;
    /// `check`: an unknown live value ends the path without an error; false: it is an error that names it.
    bool live_may_be_unknown = false;
    /// Becomes true when nobody can take more operations (a full disk, a reader that has gone): the execution ends
    /// before the next block, without a finding. Null: never.
    const bool* stop = nullptr;
};

struct ExecuteResult {
    bool completed = false;  ///< reached M30, M02 or the end of the text
    bool ended_by_live_value = false;
    bool stopped = false;      ///< by ExecuteOptions::stop
    std::uint64_t blocks = 0;  ///< blocks executed
};

/// Texts of message events; index 0 is unused.
struct EventTexts {
    std::vector<std::string> list{1};
};

/// Findings go to `diagnostics`; the first error ends the execution, as the control stops at its alarm.
ExecuteResult execute(program::Program& program, program::Library& library, const control::Dialect& dialect,
                      const machine::Machine& machine, program::LiveValues& live, operation::Tables& tables,
                      EventTexts& texts, diag::Sink& diagnostics, operation::Sink& head, const ExecuteOptions& options);

}  // namespace fagorc::passes
