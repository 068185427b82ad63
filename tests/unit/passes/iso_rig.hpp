// Runs ISO blocks through the front end and IsoRunner alone: texts in, operations and alarms out. The tests depend on
// no other part of the executor and can look at the runner between two blocks.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "frontend/frontend.hpp"
#include "ir/diag/collection.hpp"
#include "passes/execute/iso.hpp"

namespace fagorc::passes::testing {

/// Keeps what it is given.
struct Operations : operation::Sink {
    std::vector<operation::Operation> list;
    void push(const operation::Operation& o) override { list.push_back(o); }
};

struct NoLiveValues : program::LiveValues {
    std::optional<double> value(std::string_view) override { return std::nullopt; }
};

/// The built-in lathe, which the tests change.
machine::Machine built_in_lathe();

/// A runner on a machine.
class IsoRig {
  public:
    explicit IsoRig(machine::Machine machine = built_in_lathe());

    /// Runs blocks, one a line, up to the first that fails; they are program 1234. 9990, the home subroutine, is there.
    IsoRig& run(std::string_view blocks);
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
    diag::Collection findings;
    NoLiveValues live;
    frontend::Workspace workspace;
    ExecuteOptions options;
    Session session;
    IsoRunner runner;
    IsoRunner::Outcome outcome;
};

}  // namespace fagorc::passes::testing
