// Statements that neither jump nor call (8055 T chapter 12).
#include <string>

#include "passes/execute/executor.hpp"
#include "passes/execute/screen.hpp"
#include "passes/execute/texts.hpp"

namespace fagorc::passes {

using diag::Id;

void Executor::statement(const program::Statement& statement) {
    statement_ = &statement;
    std::visit([this](const auto& what) { run(what); }, statement.what);
}

void Executor::run(const program::Assign& assign) {
    for (const program::Assignment& a : assign.list) {
        evaluator_.assign(a);
        if (session_.ends()) return;
    }
}

void Executor::run(const program::If& branch) {
    const auto condition = evaluator_.known(branch.condition);
    if (!condition) return;
    for (const program::Statement& s : *condition != 0 ? branch.then : branch.otherwise) {
        statement(s);
        if (session_.ends()) return;
    }
}

void Executor::not_yet(std::string_view word) {
    const control::StatementRow* row = session_.dialect.find_statement(word);
    refuse(Id::not_yet_supported, word, row ? row->title : Text{});
}

// ---------------------------------------------------------------- programs

void Executor::run(const program::Execute& execute) {
    using program::Device;
    const auto number = evaluator_.count(execute.program);
    if (!number) return;
    // What a modal program or an executed one may not start (8055 T 12.8).
    if (execute.modal && modal_rests()) return refuse(Id::modal_program_nested);
    if (!execute.modal && in_executed_program()) return refuse(Id::exec_nested);
    if (execute.device == Device::unknown) return refuse(Id::device_unknown, "");
    // The library stands for memory and disk; what a computer sends over a line is not there.
    const bool here = execute.device == Device::memory || execute.device == Device::disk;
    program::Program* program = here ? session_.library.program(*number) : nullptr;
    if (!program || !program->header().executable) return refuse(Id::program_cannot_run, *number);
    if (execute.modal) modal_ = ModalCall{program, std::nullopt, {}};
    call_program(*program, execute.modal);
}

bool Executor::runs_now(std::uint32_t program) const {
    if (root_.number() == program || session_.program->number() == program) return true;
    for (const Frame& f : frames_)
        if (f.program->number() == program) return true;
    return false;
}

void Executor::run(const program::Open& open) {
    using program::Device;
    const auto number = evaluator_.count(open.program);
    if (!number) return;
    if (open.device != Device::memory && open.device != Device::disk) return refuse(Id::device_unknown, "");
    if (runs_now(*number)) return refuse(Id::program_busy, *number);
    const auto comment = open.comment_slot ? text_of(*session_.block, *open.comment_slot) : std::string_view();
    ++frame_changes_;
    if (session_.library.open(*number, open.append, comment) == program::Library::Opened::exists)
        refuse(Id::program_exists, *number);
}

void Executor::run(const program::Write& write) {
    const auto block = written_block(text_of(*session_.block, write.text_slot), parameter_values());
    if (session_.failed) return;
    if (!block) {  // a block with an unknown number cannot be executed later
        session_.blocked = true;
        return;
    }
    ++frame_changes_;
    if (!session_.library.write(*block)) refuse(Id::open_missing);
}

ParameterValue Executor::parameter_values() {
    return [this](double number) -> std::optional<double> {
        const double* cell = evaluator_.parameter(number, statement_->token);
        return cell && !is_unknown(*cell) ? std::optional(*cell) : std::nullopt;
    };
}

// ---------------------------------------------------------------- messages and switches

bool Executor::too_long(std::string_view text) {
    const std::size_t most = session_.dialect.limits.text_length;
    if (text.size() > most) refuse(Id::text_too_long, text.size(), most);
    return text.size() > most;
}

void Executor::run(const program::ErrorStop& error) {
    constexpr std::uint32_t most = 9999;
    std::string what;
    double number = 0;
    if (error.number.present()) {
        const auto n = evaluator_.count(error.number);
        if (!n) return;
        if (*n > most) return refuse(Id::error_number_out_of_range, most);
        number = *n;
        what = std::to_string(*n);
    }
    if (error.text_slot) {
        const std::string_view text = text_of(*session_.block, *error.text_slot);
        if (too_long(text)) return;
        what += (what.empty() ? "\"" : " \"") +
                with_marked_values(text, parameter_values()).value_or(std::string(text)) + '"';
    }
    if (session_.failed) return;
    iso_.push_event({operation::Event::Kind::error, {}, 0, number});
    refuse(Id::error_statement, what);
}

void Executor::run(const program::Message& message) {
    const std::string_view text = text_of(*session_.block, message.text_slot);
    if (too_long(text)) return;
    std::string shown = with_marked_values(text, parameter_values()).value_or(std::string(text));
    if (session_.failed) return;
    const auto [at, added] =
        text_ids_.try_emplace(std::move(shown), static_cast<std::uint32_t>(session_.texts.list.size()));
    if (added) session_.texts.list.push_back(at->first);
    iso_.push_event({operation::Event::Kind::message, {}, at->second, 0});
}

void Executor::run(const program::GraphicZone& zone) {
    const double z_min = evaluator_.value(zone.z_min), z_max = evaluator_.value(zone.z_max);
    const double inner = evaluator_.value(zone.inner), outer = evaluator_.value(zone.outer);
    if (session_.failed) return;
    if (z_min > z_max) return refuse(Id::graphic_zone_limits, z_min, z_max);
    if (inner > outer) return refuse(Id::graphic_zone_limits, inner, outer);
    iso_.push_event({operation::Event::Kind::graphic_zone, {}, 0, 0});
}

void Executor::run(const program::Enable& enable) {
    iso_.enable(enable);
}

// ---------------------------------------------------------------- what needs the machine

void Executor::run(const program::Probe& probe) {
    const auto cycle = evaluator_.count(probe.cycle);
    if (!cycle) return;
    const std::string word = "PROBE " + std::to_string(*cycle);
    if (!session_.dialect.find_statement(word)) return refuse(Id::probe_cycle_undefined, *cycle);
    not_yet(word);
}

/// Nothing interrupts a compilation (8055 T 12.7).
void Executor::run(const program::Reposition&) {
    refuse(Id::reposition_outside_interrupt);
}

/// A file of the customisation channel is checked as a whole; there is nothing to execute in it (8055 T 12.9).
void Executor::run(const program::Screen& screen) {
    program::Program& program = *session_.program;
    const program::Cursor here = session_.block->here;
    const bool customisation = is_customisation(program);
    session_.block = program.read(here);
    if (!customisation) return refuse(Id::screen_statement_in_part, session_.dialect.word(screen.word));
    ScreenChecker checker(session_);
    for (program::Cursor at = program.start(); const program::Block* block = program.read(at); at = block->next) {
        session_.block = block;
        report_findings(*block);
        checker.check();
    }
    result_.completed = !session_.failed;
    ended_ = true;
}

}  // namespace fagorc::passes
