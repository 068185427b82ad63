// One program with everything that it is run with: the wiring of the phases, for every subcommand.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "backends/backend.hpp"
#include "frontend/frontend.hpp"
#include "passes/execute/execute.hpp"
#include "passes/pipeline.hpp"
#include "tools/fagorc/console.hpp"
#include "tools/fagorc/live_values.hpp"
#include "tools/fagorc/settings.hpp"

namespace fagorc::tool {

class Part final : public passes::Places, public backends::Programs {
  public:
    Part(const Settings& settings, Console& console);
    ~Part() override;

    /// Reads machine, tables, libraries and the program; false when one of them cannot be used (reported).
    bool load(const std::string& path);

    struct Run {
        std::string_view stop_after;  ///< see passes::Pipeline::Options
        bool checking = false;        ///< unknown live values end a path without an error
        const bool* stop = nullptr;   ///< see passes::ExecuteOptions
    };
    /// Executes the program into `tail` and finds what is wrong in the rest of its text.
    passes::ExecuteResult run(operation::Sink& tail, const Run& run);

    program::Program& program() { return *program_; }
    frontend::Workspace& workspace() { return *workspace_; }
    const machine::Machine& machine() const { return machine_; }
    const control::Dialect& dialect() const { return *dialect_; }
    const operation::Tables& tables() const { return tables_; }
    diag::Sink& diagnostics() { return diagnostics_; }
    backends::Job job();
    /// The machine for the summary: "built-in lathe" or the file's name.
    std::string machine_name() const;

    diag::Place of(const operation::Context& at) override { return place(at); }
    diag::Place place(const operation::Context& at) const override;
    std::optional<std::uint32_t> label(const operation::Context& at) const override;
    std::string_view name(diag::FileId file) const override { return workspace_->name(file); }
    std::string_view text(diag::FileId file, std::size_t from) const override;

  private:
    bool load_machine();

    const Settings& settings_;
    const frontend::Workspace* shown_ = nullptr;  ///< what the console reads names and lines from
    diag::Sink& diagnostics_;
    const control::Dialect* dialect_ = nullptr;
    std::unique_ptr<frontend::Workspace> workspace_;
    program::Program* program_ = nullptr;
    machine::Machine machine_;
    SetValues live_;
    operation::Tables tables_;
    passes::EventTexts texts_;
};

}  // namespace fagorc::tool
