// Runs ISO blocks through IsoRunner alone: texts in, operations and alarms out. The blocks are put together here, word
// by word, from the control's tables, so that these tests depend on no other part of the executor.
#pragma once

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "frontend/controls/controls.hpp"
#include "passes/execute/iso.hpp"

namespace fagorc::passes::testing {

/// Keeps what it is given.
struct Operations : operation::Sink {
    std::vector<operation::Operation> list;
    void push(const operation::Operation& o) override { list.push_back(o); }
};
struct Findings : diag::Sink {
    std::vector<diag::Diagnostic> list;
    void report(diag::Diagnostic d) override { list.push_back(std::move(d)); }
};

struct NoLiveValues : program::LiveValues {
    std::optional<double> value(std::string_view) override { return std::nullopt; }
};

/// A program that only gives places.
struct EmptyProgram : program::Program {
    program::Header head;
    diag::FileId file() const override { return diag::FileId{0}; }
    std::optional<std::uint32_t> number() const override { return 1234; }
    const program::Header& header() override { return head; }
    program::Cursor first() override { return {}; }
    program::Cursor start() override { return {}; }
    const program::Block* read(program::Cursor) override { return nullptr; }
    const program::Block* rebind(const program::Block&, std::string_view, diag::Sink&) override { return nullptr; }
    std::optional<program::Cursor> label(std::uint32_t) override { return std::nullopt; }
    const program::Subroutine* subroutine(std::uint32_t n, bool) override { return n == 9990 ? &home : nullptr; }
    std::vector<program::PlacedToken> tokens(const program::Block&) override { return {}; }
    diag::Place place_of_line(std::uint32_t) override { return {}; }
    std::optional<std::uint32_t> label_of_line(std::uint32_t) override { return std::nullopt; }
    void check_unread(diag::Sink&) override {}
    std::string_view text(std::size_t) override { return {}; }
    program::Subroutine home;  ///< 9990, the built-in lathe's home subroutine
};

struct EmptyLibrary : program::Library {
    program::Program* program(std::uint32_t) override { return nullptr; }
    Found subroutine(std::uint32_t) override { return {}; }
    Opened open(std::uint32_t, std::optional<bool>, std::string_view) override { return Opened::exists; }
    bool write(std::string_view) override { return false; }
    void close() override {}
};

/// The lathe of the specification's sweeps: all nine axes, 99 tools, no limits (8055-core 15).
machine::Machine sweep_lathe();

/// A runner on a machine.
class IsoBench {
  public:
    explicit IsoBench(machine::Machine machine = sweep_lathe());

    /// Runs blocks, one a line, up to the first that fails.
    IsoBench& run(std::string_view blocks);
    /// Alarm of the last error ("1084"), its name where it has no alarm, empty where there was none.
    std::string alarm() const;
    /// Names of the warnings so far.
    std::vector<std::string> warnings() const;

    /// The moves so far; other operations are left out.
    std::vector<operation::Operation> moves() const;
    /// The last operation of a kind.
    template <class T>
    const T& last() const {
        for (auto o = out.list.rbegin(); o != out.list.rend(); ++o)
            if (const auto* found = std::get_if<T>(&o->what)) return *found;
        static const T none{};
        return none;
    }
    const operation::Operation& last_move() const;
    const operation::State& state(const operation::Operation& o) const { return tables.states[o.at.state]; }
    const operation::Frame& frame(const operation::Operation& o) const { return tables.frames[o.at.frame]; }
    /// A program-state variable, NaN where the runner does not know it.
    double variable(std::string_view name, std::optional<Axis> axis = {}, std::optional<long> index = {});
    /// Row of a variable in the control's table.
    std::uint16_t variable_row(std::string_view name, bool per_axis) const;

    operation::Tables tables;
    EventTexts texts;
    Operations out;
    Findings findings;
    NoLiveValues live;
    EmptyLibrary library;
    EmptyProgram program;
    ExecuteOptions options;
    Session session;
    IsoRunner runner;
    IsoRunner::Outcome outcome;

  private:
    std::deque<std::string> texts_of_blocks_;
    std::deque<program::BlockTemplate> shapes_;
    std::deque<std::vector<program::Quantity>> slots_;
    std::uint32_t line_ = 0;
};

}  // namespace fagorc::passes::testing
