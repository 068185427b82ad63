// Gives programs, call chains, states and texts the numbers by which an output refers to them: from 0, in the order of
// first use, so that the numbers depend on the moves alone and not on what the executor interned on the way.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "backends/backend.hpp"
#include "ir/operation/operation.hpp"

namespace fagorc::backends {

inline constexpr std::uint32_t no_number = 0xffffffff;

/// What a state number stands for: the modal state, the zero offset and the spindle speed (rpm or m/min).
struct Situation {
    operation::StateId state{};
    operation::FrameId frame{};
    double speed = 0;
    friend bool operator==(const Situation&, const Situation&) = default;
};

/// A sink that numbers. The hooks are called once for each new number, before the call that asked returns.
class NumberingSink : public operation::Sink {
  protected:
    explicit NumberingSink(const Job& job) : job_(job) {}

    const Job& job() const { return job_; }
    std::uint32_t program_number(diag::FileId file);
    std::uint32_t chain_number(operation::ChainId id) {
        return id == last_chain_ && last_chain_number_ != no_number ? last_chain_number_ : find_chain(id);
    }
    std::uint32_t state_number(const operation::Context& at) {
        const Situation wanted{at.state, at.frame, at.speed};
        return recent_count_ > 0 && recent_[0].situation == wanted ? recent_[0].number : find_state(wanted);
    }
    /// Of an index into the event texts; index 0 is no text.
    std::uint32_t text_number(std::uint32_t index);
    /// Used programs, in the order of their numbers.
    const std::vector<diag::FileId>& programs() const { return used_programs_; }

    virtual void new_program(std::uint32_t number, diag::FileId file) = 0;
    /// The root chain has no caller: `caller` is no_number.
    virtual void new_chain(std::uint32_t number, std::uint32_t program, std::uint32_t caller, std::uint32_t line) = 0;
    virtual void new_state(std::uint32_t number, const Situation& situation) = 0;
    virtual void new_text(std::uint32_t number, std::string_view text) = 0;

  private:
    std::uint32_t find_chain(operation::ChainId id);
    std::uint32_t find_state(const Situation& wanted);

    struct Recent {
        Situation situation;
        std::uint32_t number = 0;
    };
    /// Spindle speeds may change with every block, so not all situations are kept: one that was not among the last ones
    /// gets a new number. A loop over more than this many states is rare, and its file only grows a little.
    static constexpr std::size_t recent_states = 64;
    static constexpr std::ptrdiff_t near_front = 8;

    Job job_;
    std::vector<std::uint32_t> chain_numbers_;  ///< by ChainId
    std::vector<std::uint32_t> text_numbers_;   ///< by index of the event texts
    std::vector<diag::FileId> used_programs_;
    std::array<Recent, recent_states> recent_;  ///< those used last in front
    std::size_t recent_count_ = 0;
    std::uint32_t chains_ = 0, states_ = 0, texts_ = 0;
    operation::ChainId last_chain_{};
    std::uint32_t last_chain_number_ = no_number;
};

}  // namespace fagorc::backends
