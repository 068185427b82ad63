// Turns a trajectory file back into operations, so that every backend can print it: `dump FILE.ftj --to csv` is
// `compile --to csv` byte for byte.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "backends/backend.hpp"
#include "frontend/frontend.hpp"
#include "runtime/player/trajectory.hpp"

namespace fagorc::tool {

/// The operations behind a trajectory that has been verified, or that ends early.
class Replay final : public backends::Programs {
  public:
    explicit Replay(const player::Trajectory& trajectory);

    /// What a backend needs; refers to this object.
    backends::Job job(diag::Sink& diagnostics) const;
    /// Pushes all moves and events in their order, then `finish`; ends early once `*stop` is true.
    void run(operation::Sink& sink, const bool* stop = nullptr) const;

    std::string_view name(diag::FileId file) const override;
    std::string_view text(diag::FileId file, std::size_t from) const override;
    /// No place: the programs are not files here.
    diag::Place place(const operation::Context&) const override { return {}; }
    std::optional<std::uint32_t> label(const operation::Context& at) const override;

  private:
    struct Situation {
        operation::StateId state{};
        operation::FrameId frame{};
        double speed = 0;
    };
    struct Source {
        std::string name, text;
        program::Program* program = nullptr;  ///< the text as the control reads it; null: the control is not known
    };

    void read_meta();
    void read_states();
    void read_sources();
    bool context(std::uint32_t chain, std::uint32_t state, operation::Context& at) const;
    bool push_move(const player::Move& move, operation::Sink& sink) const;
    bool push_event(std::uint64_t& n, operation::Sink& sink) const;

    /// What is wrong with a source was told when it was compiled.
    struct Deaf final : diag::Sink {
        void report(diag::Diagnostic) override {}
    };

    const player::Trajectory& trajectory_;
    Deaf deaf_;
    std::unique_ptr<frontend::Workspace> workspace_;
    operation::Tables tables_;
    machine::Machine machine_;
    std::string producer_;
    std::vector<Situation> situations_;
    std::vector<operation::ChainId> chains_;
    std::vector<std::string> texts_{1};
    std::vector<Source> sources_;
};

}  // namespace fagorc::tool
