// What the parts of the executor share while one program runs.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <set>
#include <string>
#include <tuple>

#include "ir/base/whole.hpp"
#include "ir/diag/catalogue.hpp"
#include "passes/execute/execute.hpp"
#include "passes/execute/parameters.hpp"

namespace fagorc::passes {

/// An unknown value: only `check` computes with it; it goes through every operation as NaN does.
inline constexpr double unknown_value = std::numeric_limits<double>::quiet_NaN();
inline bool is_unknown(double v) { return std::isnan(v); }

/// How far a computed number may be from the whole number that it stands for: P(expression), N(expression), indices.
/// SIN 180 is 1e-16, not 0, in any arithmetic.
inline constexpr double index_tolerance = 1e-3;

/// One execution: what it reads, where it is, where its results go.
struct Session {
    const control::Dialect& dialect;
    machine::Machine machine;              ///< a copy: programs write tool, offset and origin tables
    program::Library& library;
    program::LiveValues& live;
    operation::Tables& tables;
    EventTexts& texts;
    diag::Sink& diagnostics;
    operation::Sink& head;
    const ExecuteOptions& options;
    Parameters parameters;

    program::Program* program = nullptr;   ///< of the block being executed
    const program::Block* block = nullptr;
    operation::ChainId chain{};
    std::uint16_t pass = 0;
    bool failed = false;                   ///< an error was reported: the execution ends
    bool blocked = false;                  ///< an unknown value was needed: the path ends (its name in `wanted`)
    std::string wanted{};                    ///< the live variable that was asked for last and is unknown

    /// Reports about tokens [first, end) of the block being executed.
    template <class... Arguments>
    void report(diag::Id id, std::uint32_t first, std::uint32_t end, Arguments&&... arguments) {
        if (diag::row(id).severity == diag::Severity::error) failed = true;
        diagnostics.report(id, program->place(*block, first, end), std::forward<Arguments>(arguments)...);
    }
    /// Reports about the whole block.
    template <class... Arguments>
    void report_block(diag::Id id, Arguments&&... arguments) {
        if (diag::row(id).severity == diag::Severity::error) failed = true;
        diagnostics.report(id, program->place(*block), std::forward<Arguments>(arguments)...);
    }
    /// The same for warnings of blocks that may run many times: once a place.
    template <class... Arguments>
    void report_once(diag::Id id, std::uint32_t first, std::uint32_t end, Arguments&&... arguments) {
        if (reported.emplace(program->file(), block->here.offset, first, id).second)
            report(id, first, end, std::forward<Arguments>(arguments)...);
    }
    bool ends() const { return failed || blocked; }
    /// Tokens [first, end) of the block being executed as written.
    std::string_view text(std::uint32_t first, std::uint32_t end) const {
        const diag::Place place = program->place(*block, first, end);
        return block->text.substr(place.column - 1, place.end_column - place.column);
    }

    /// The cell of the parameter with the number that tokens [first, end) name; null: reported.
    double* parameter(double number, std::uint32_t first, std::uint32_t end) {
        const auto whole = whole_number(number);
        double* const cell = whole ? parameters.find(*whole) : nullptr;
        if (cell == nullptr) [[unlikely]]
            parameter_missing(number, first, end);
        return cell;
    }
    void parameter_missing(double number, std::uint32_t first, std::uint32_t end);

    std::set<std::tuple<diag::FileId, std::uint64_t, std::uint32_t, diag::Id>> reported{};   ///< by report_once
};

}  // namespace fagorc::passes
