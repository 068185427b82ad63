#include "passes/execute/executor.hpp"

#include <algorithm>

#include "ir/program/findings.hpp"

namespace fagorc::passes {

using diag::Id;

namespace {

/// Leaves out the findings of blocks that were told when they were executed.
class Untold final : public diag::Sink {
  public:
    Untold(const std::set<std::pair<diag::FileId, std::uint64_t>>& told, diag::Sink& next) : told_(told), next_(next) {}
    void report(diag::Diagnostic d) override {
        if (!told_.contains({d.place.file, d.place.block})) next_.report(std::move(d));
    }

  private:
    const std::set<std::pair<diag::FileId, std::uint64_t>>& told_;
    diag::Sink& next_;
};

}  // namespace

Executor::Executor(program::Program& root, Session& session)
    : root_(root), session_(session), iso_(session), variables_(session, iso_), evaluator_(session, variables_) {
    frames_.reserve(static_cast<std::size_t>(session.dialect.limits.subroutine_levels) + 1);
}

ExecuteResult Executor::run() {
    if (begin()) {
        while (!ended_) {
            if (next_.offset == section_end_) {
                next_run();
                continue;
            }
            const program::Block* block = session_.program->read(next_);
            if (!block) {
                end_of_text();
                continue;
            }
            session_.block = block;
            next_ = block->next;
            if (!fuel()) break;
            step(*block);
            result_.stopped = session_.options.stop != nullptr && *session_.options.stop;
            ended_ = ended_ || session_.ends() || result_.stopped;
        }
    }
    if (result_.stopped) return result_;
    result_.ended_by_live_value = session_.blocked;
    if (session_.blocked) session_.report_block(Id::path_ends_at_live_value, session_.wanted);
    Untold untold(told_, session_.diagnostics);
    root_.check_unread(untold);
    if (result_.completed) session_.head.finish();
    return result_;
}

bool Executor::begin() {
    refuel();
    enter(root_);
    session_.chain = session_.tables.chains.intern({root_.file(), {}, 0});
    if (!root_.header().executable) {
        session_.diagnostics.report(Id::not_executable, root_.place_of_line(1));
        return false;
    }
    next_ = root_.start();
    const bool library = holds_only_subroutines();
    result_.completed = library && !session_.failed;
    return !library && !session_.failed;
}

/// A file that begins with a SUB and ends with a RET defines subroutines and has no main part (ours: the manual knows
/// none). Its blocks are checked here, not executed.
bool Executor::holds_only_subroutines() {
    bool first = true, ends_with_return = false;
    for (program::Cursor at = next_; const program::Block* block = root_.read(at); at = block->next) {
        session_.block = block;
        report_findings(*block);
        if (std::holds_alternative<std::monostate>(block->shape->body)) continue;
        const auto* s = std::get_if<program::Statement>(&block->shape->body);
        if (first && !(s && std::holds_alternative<program::SubroutineBegin>(s->what))) return false;
        first = false;
        ends_with_return = s && std::holds_alternative<program::Return>(s->what);
    }
    return ends_with_return;
}

void Executor::enter(program::Program& program) {
    session_.program = &program;
    session_.parameters.allow_oem(program.header().oem);
}

/// The next block may run.
bool Executor::fuel() {
    if (++result_.blocks <= fuel_) return true;
    const ExecuteOptions& o = session_.options;
    if (result_.blocks > o.max_blocks)
        session_.report_block(Id::fuel_used_up, o.max_blocks);
    else
        session_.report_block(Id::no_motion_in_sight, o.max_blocks_without_motion);
    return false;
}

/// A move was made: the program gets somewhere.
void Executor::refuel() {
    const ExecuteOptions& o = session_.options;
    fuel_ = std::min(o.max_blocks, result_.blocks + o.max_blocks_without_motion);
}

void Executor::step(const program::Block& block) {
    const program::BlockTemplate& shape = *block.shape;
    report_findings(block);
    if (shape.skip_marks & session_.options.skip_marks) return;  // a skipped block changes nothing (8055 T 2.1.1)
    if (shape.broken) {
        session_.failed = true;
        return;
    }
    if (std::holds_alternative<program::IsoBlock>(shape.body)) {
        iso_block(block);
    } else if (const auto* s = std::get_if<program::Statement>(&shape.body)) {
        if (may_repeat(repeats(*s))) statement(*s);
    }
}

void Executor::report_findings(const program::Block& block) {
    if (block.shape->findings.empty()) return;
    if (told_.emplace(session_.program->file(), block.here.offset).second &&
        program::report_findings(*session_.program, block, session_.diagnostics))
        session_.failed = true;
}

/// RPT, CALL, PCALL and LL may be repeated, no other statement (8055 T 2.1.3, 12.4, 12.5).
bool Executor::repeats(const program::Statement& statement) const {
    if (std::holds_alternative<program::Repeat>(statement.what)) return true;
    const auto* call = std::get_if<program::Call>(&statement.what);
    return call && call->kind != program::Call::Kind::modal && call->kind != program::Call::Kind::by_g_code;
}

bool Executor::repetition_fits(bool allowed) {
    const program::BlockTemplate& shape = *session_.block->shape;
    const std::uint32_t most = session_.dialect.limits.repetitions;
    const double count = session_.block->slots[*shape.repeat_slot].value;
    if (!allowed)
        session_.report(Id::repetition_not_possible, shape.repeat_token, shape.repeat_token + 1u);
    else if (!(count >= 0 && count <= most))
        session_.report(Id::repetitions_out_of_range, shape.repeat_token, shape.repeat_token + 1u, most);
    else if (!whole_number(count))
        session_.report(Id::decimals_not_allowed, shape.repeat_token, shape.repeat_token + 1u, 'N', count);
    return !session_.failed;
}

/// The repetition count of the block, 1 where it has none.
std::uint32_t Executor::runs() const {
    const program::Block& block = *session_.block;
    if (!block.shape->repeat_slot) return 1;
    return whole_number(block.slots[*block.shape->repeat_slot].value).value_or(0);  // `repetition_fits` looked at it
}

void Executor::iso_block(const program::Block& block) {
    const program::IsoBlock* iso = &std::get<program::IsoBlock>(block.shape->body);
    if (block.shape->by_parameter && !(iso = bind_parameters(block))) return;
    // Only what moves under a modal call is executed N times (8055 T 2.1.3).
    if (!may_repeat(modal_ && iso->has_axis)) return;

    const IsoRunner::Outcome outcome = iso_.run(*iso);
    if (session_.ends()) return;
    if (outcome.moved) refuel();
    if (outcome.program_end) return end_of_program();
    if (outcome.subroutine) return call_function(*outcome.subroutine);
    if (outcome.moved && modal_ && !modal_rests()) call_modal();
}

/// `GP1`: the block is read again with the value in place of the parameter (8055 T 2).
const program::IsoBlock* Executor::bind_parameters(const program::Block& block) {
    const auto tokens = session_.program->tokens(block);
    std::string text;
    std::size_t copied = 0;
    for (std::size_t i = 0; i + 2 < tokens.size(); ++i) {
        if (tokens[i].kind != program::letter_token('G') || tokens[i + 1].kind != program::letter_token('P')) continue;
        const program::PlacedToken& number = tokens[i + 2];
        const auto slot = std::find_if(block.slots.begin(), block.slots.end(),
                                       [&](const program::Quantity& q) { return q.at == number.at; });
        if (slot == block.slots.end()) continue;
        const double* cell = evaluator_.parameter(slot->value, static_cast<std::uint16_t>(i + 1));
        if (!cell) return nullptr;
        if (is_unknown(*cell)) {
            session_.blocked = true;
            return nullptr;
        }
        if (*cell < 0 || *cell > 999 || *cell != std::trunc(*cell)) {
            session_.report(Id::parameter_value_unfit, static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(i + 3),
                            block.text.substr(tokens[i + 1].at, number.at + number.length - tokens[i + 1].at), *cell);
            return nullptr;
        }
        text.append(block.text, copied, tokens[i + 1].at - copied);
        text += std::to_string(static_cast<int>(*cell));
        copied = number.at + number.length;
    }
    text.append(block.text, copied, std::string::npos);
    const program::Block* bound = session_.program->rebind(block, text, session_.diagnostics);
    const auto* iso = bound ? std::get_if<program::IsoBlock>(&bound->shape->body) : nullptr;
    if (!iso) {
        session_.failed = true;
        return nullptr;
    }
    session_.block = bound;
    return iso;
}

void Executor::end_of_text() {
    while (!frames_.empty() && frames_.back().kind == Frame::Kind::section) leave();
    if (frames_.empty()) {
        session_.diagnostics.report(Id::no_program_end, session_.program->place_of_line(next_.line));
        return complete();
    }
    if (frames_.back().kind == Frame::Kind::program) return end_of_program();
    session_.failed = true;
    session_.diagnostics.report(Id::return_missing, session_.program->place_of_line(frames_.back().begin.line),
                                frames_.back().number);
    ended_ = true;
}

/// M30 or M02: of a program that EXEC started it goes back without the general reset (8055 T 12.8 leaves it open).
void Executor::end_of_program() {
    if (!in_executed_program()) return complete();
    while (frames_.back().kind != Frame::Kind::program) leave();
    pop();
}

void Executor::complete() {
    iso_.push_event({operation::Event::Kind::program_end, {}, 0, 0});
    iso_.reset();
    session_.library.close();
    result_.completed = true;
    ended_ = true;
}

ExecuteResult execute(program::Program& program, program::Library& library, const control::Dialect& dialect,
                      const machine::Machine& machine, program::LiveValues& live, operation::Tables& tables,
                      EventTexts& texts, diag::Sink& diagnostics, operation::Sink& head,
                      const ExecuteOptions& options) {
    Session session{.dialect = dialect,
                    .machine = machine,
                    .library = library,
                    .live = live,
                    .tables = tables,
                    .texts = texts,
                    .diagnostics = diagnostics,
                    .head = head,
                    .options = options,
                    .parameters = Parameters(dialect, machine.parameters)};
    return Executor(program, session).run();
}

}  // namespace fagorc::passes
