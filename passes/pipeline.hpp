// The order of the passes, written once.
#pragma once

#include <memory>
#include <string_view>
#include <vector>

#include "ir/diag/diagnostic.hpp"
#include "ir/machine/machine.hpp"
#include "ir/operation/operation.hpp"

namespace fagorc::passes {

/// Turns a line of a program back into a place when a pass has a finding about an operation.
class Places {
  public:
    virtual ~Places() = default;
    virtual diag::Place of(const operation::Context& at) = 0;
};

/// What every pass may look at.
struct Environment {
    const machine::Machine& machine;
    const operation::Tables& tables;
    diag::Sink& diagnostics;
    Places& places;
};

/// The chain contour -> cycles -> compensation -> axes -> check -> tail.
class Pipeline {
  public:
    /// The name for what the executor makes, before any pass.
    static constexpr std::string_view before_all = "execute";

    struct Options {
        std::string_view stop_after;  ///< a pass's name: its output goes to the tail; `before_all`; empty: all passes
        bool verify = false;          ///< verifiers between the passes
    };
    Pipeline(const Environment& environment, operation::Sink& tail, const Options& options);
    ~Pipeline();
    operation::Sink& head();
    /// Names of the passes in their order.
    static std::vector<std::string_view> names();

  private:
    std::vector<std::unique_ptr<operation::Sink>> stages_;  ///< last first
    operation::Sink* head_;
};

}  // namespace fagorc::passes
