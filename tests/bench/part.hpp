// One program in the front end, with all that the phases behind it need: what `fagorc compile` wires, without a
// console.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "backends/backend.hpp"
#include "frontend/frontend.hpp"
#include "ir/diag/collection.hpp"
#include "passes/execute/session.hpp"
#include "passes/pipeline.hpp"

namespace fagorc::bench {

/// Takes all and keeps nothing.
struct NullSink final : operation::Sink {
    void push(const operation::Operation&) override {}
};

class Part final : public passes::Places, public backends::Programs {
  public:
    /// A program of these blocks, made `whole` (programs.hpp).
    explicit Part(const std::string& blocks);

    /// Executes the program into `head`; again and again if asked. Ends the process when the program has an error: then
    /// there would be nothing to measure.
    passes::ExecuteResult execute(operation::Sink& head);
    /// The operations that the program makes, before any pass.
    std::vector<operation::Operation> operations();
    /// The same behind all passes, as the backends get them.
    std::vector<operation::Operation> moves();

    passes::Environment environment() { return {machine_, tables_, findings_, *this}; }
    backends::Job job() { return {tables_, texts_.list, machine_, *this, findings_, "bench"}; }
    /// For phases inside of the executor; nothing has been executed in it.
    passes::Session session(operation::Sink& head);
    program::Program& program() { return program_; }

    diag::Place of(const operation::Context& at) override { return place(at); }
    std::string_view name(diag::FileId) const override { return "part.pit"; }
    std::string_view text(diag::FileId, std::size_t from) const override { return program_.text(from); }
    diag::Place place(const operation::Context& at) const override { return program_.place_of_line(at.line); }
    std::optional<std::uint32_t> label(const operation::Context& at) const override {
        return program_.label_of_line(at.line);
    }

  private:
    struct NoLiveValues final : program::LiveValues {
        std::optional<double> value(std::string_view) override { return std::nullopt; }
    };

    const control::Dialect& dialect_;
    diag::Collection findings_;
    frontend::Workspace workspace_;
    program::Program& program_;
    machine::Machine machine_;
    NoLiveValues live_;
    operation::Tables tables_;
    passes::EventTexts texts_;
    passes::ExecuteOptions options_;
};

}  // namespace fagorc::bench
