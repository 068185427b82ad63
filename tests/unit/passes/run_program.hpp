// Runs a program text through the front end and the executor, and keeps what came out.
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/frontend.hpp"
#include "ir/diag/diagnostic.hpp"
#include "ir/operation/operation.hpp"
#include "passes/execute/execute.hpp"

namespace fagorc::passes {

struct ProgramRun {
    ExecuteResult result;
    std::vector<diag::Diagnostic> findings;
    std::vector<operation::Operation> operations;
    std::vector<std::string> messages;  ///< texts of the MSG events in their order
    std::vector<operation::Chain> chains;
    frontend::Statistics statistics;

    /// End points of the moves as "X Z", X as a radius.
    std::vector<std::string> moves() const;
    /// "code alarm" of each finding that is an error, or the names of all findings.
    std::string errors() const;
    bool has(diag::Id id) const;
};

struct RunOptions {
    std::map<std::string, double, std::less<>> live{};           ///< --set
    std::vector<std::pair<std::string, std::string>> library{};  ///< "000100.PIT" and its text
    ExecuteOptions execute{};
    frontend::Options caches{};
};

ProgramRun run_program(std::string_view text, const RunOptions& options = {});

/// The last message of a program: tests let it say `?P1`.
std::string last_message(std::string_view text, const RunOptions& options = {});

}  // namespace fagorc::passes
