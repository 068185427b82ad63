// Runs the blocks of a program in the control's order: the loop, jumps, calls, repetitions (8055 T chapter 12).
#pragma once

#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "passes/execute/expression.hpp"
#include "passes/execute/frame.hpp"
#include "passes/execute/iso.hpp"
#include "passes/execute/loops.hpp"
#include "passes/execute/session.hpp"
#include "passes/execute/texts.hpp"
#include "passes/execute/variables.hpp"

namespace fagorc::passes {

class Executor {
  public:
    Executor(program::Program& root, Session& session);
    ExecuteResult run();

  private:
    // executor.cpp: the loop
    bool begin();
    bool holds_only_subroutines();
    void step(const program::Block& block);
    void report_findings(const program::Block& block);
    void iso_block(const program::Block& block);
    const program::IsoBlock* bind_parameters(const program::Block& block);
    void end_of_text();
    void end_of_program();
    void complete();
    bool fuel();
    void refuel();
    bool repeats(const program::Statement& statement) const;
    /// The repetition count of the block, if it has one, is in range and `allowed`.
    bool may_repeat(bool allowed) { return !session_.block->shape->repeat_slot || repetition_fits(allowed); }
    bool repetition_fits(bool allowed);
    std::uint32_t runs() const;

    // statements.cpp
    void statement(const program::Statement& statement);
    void run(const program::Assign& assign);
    void run(const program::If& branch);
    void run(const program::Execute& execute);
    void run(const program::Open& open);
    void run(const program::Write& write);
    void run(const program::ErrorStop& error);
    void run(const program::Message& message);
    void run(const program::GraphicZone& zone);
    void run(const program::Enable& enable);
    void run(const program::Probe& probe);
    void run(const program::Reposition& reposition);
    void run(const program::Screen& screen);
    void not_yet(std::string_view word);
    ParameterValue parameter_values();
    bool too_long(std::string_view text);
    bool runs_now(std::uint32_t program) const;
    template <class... A>
    void refuse(diag::Id id, A&&... arguments) {
        session_.report(id, statement_->token, statement_->end_token, std::forward<A>(arguments)...);
    }

    // calls.cpp: jumps, calls, repetitions
    void run(const program::Jump& jump);
    void run(const program::Repeat& repeat);
    void run(const program::SubroutineBegin& begin);
    void run(const program::Return& end);
    void run(const program::Call& call);
    void run(const program::EndModal& end);
    struct Found {
        program::Program* program = nullptr;
        const program::Subroutine* subroutine = nullptr;
    };
    Found find(std::uint32_t number, program::Call::Kind kind);
    bool take_arguments(const std::vector<program::Assignment>& list, Arguments& out);
    void call(const Found& found, const Arguments* arguments, std::uint32_t runs, bool modal);
    void call_function(std::uint32_t number);
    void call_program(program::Program& program, bool modal);
    void call_modal();
    bool push(Frame frame, program::Program& into, program::Cursor at);
    void pop();
    void leave();
    void next_run();
    void jump_to(program::Cursor target);
    bool contains(const Frame& frame, program::Cursor target);
    bool modal_rests() const { return modal_depth_ != 0; }
    bool in_executed_program() const { return executed_programs_ != 0; }
    void enter(program::Program& program);

    program::Program& root_;
    Session& session_;
    IsoRunner iso_;
    Variables variables_;
    Evaluator evaluator_;
    LoopWatch loop_;
    const program::Statement* statement_ = nullptr;  ///< being executed
    program::Cursor next_;
    static constexpr std::uint64_t no_section = ~std::uint64_t{0};
    std::uint64_t section_end_ = no_section;  ///< of the innermost frame, where that is a section
    std::vector<Frame> frames_;
    std::optional<ModalCall> modal_;
    int modal_depth_ = 0, executed_programs_ = 0;
    std::uint64_t frame_changes_ = 0;
    std::uint64_t fuel_ = 0;                                 ///< highest number of blocks so far
    std::set<std::pair<diag::FileId, std::uint64_t>> told_;  ///< blocks whose findings were reported
    bool ended_ = false;
    ExecuteResult result_;
    std::unordered_map<std::string, std::uint32_t> text_ids_;
};

}  // namespace fagorc::passes
