// Jumps, calls and repetitions (8055 T 12.4, 12.5).
#include <algorithm>

#include "passes/execute/executor.hpp"

namespace fagorc::passes {

using diag::Id;

// ---------------------------------------------------------------- frames

bool Executor::push(Frame frame, program::Program& into, program::Cursor at) {
    const auto most = static_cast<std::size_t>(session_.dialect.limits.subroutine_levels);
    if (frames_.size() >= most) {
        session_.report_block(Id::nesting_exceeded, most);
        return false;
    }
    if (frame.own_level && !session_.parameters.enter()) {
        session_.report_block(Id::local_levels_used_up, session_.dialect.limits.parameter_levels);
        return false;
    }
    frame.begin = at;
    frame.program = session_.program;
    frame.call = session_.block->here;
    frame.back = next_;
    frame.chain = session_.chain;
    frame.pass = session_.pass;
    frame.call_parameters = variables_.call_parameters;
    session_.chain = session_.tables.chains.intern({into.file(), session_.chain, session_.block->here.line});
    session_.pass = 0;
    modal_depth_ += frame.modal;
    executed_programs_ += frame.kind == Frame::Kind::program;
    ++frame_changes_;
    frames_.push_back(frame);
    section_end_ = frame.kind == Frame::Kind::section ? frame.end : no_section;
    enter(into);
    next_ = at;
    return true;
}

/// The innermost frame is done: what it was called from goes on.
void Executor::pop() {
    const Frame f = frames_.back();
    leave();
    enter(*f.program);
    next_ = f.back;
    if (!f.of_function) return;
    session_.block = session_.program->read(f.call);  // the function belongs to the block that called
    if (const auto following = iso_.subroutine_ended()) call_function(*following);
}

/// The innermost frame is given up where it stands.
void Executor::leave() {
    const Frame f = frames_.back();
    if (f.own_level) session_.parameters.leave();
    variables_.call_parameters = f.call_parameters;
    session_.chain = f.chain;
    session_.pass = f.pass;
    modal_depth_ -= f.modal;
    executed_programs_ -= f.kind == Frame::Kind::program;
    ++frame_changes_;
    frames_.pop_back();
    const bool section = !frames_.empty() && frames_.back().kind == Frame::Kind::section;
    section_end_ = section ? frames_.back().end : no_section;
}

/// The innermost frame came to its end: once more, or back.
void Executor::next_run() {
    Frame& f = frames_.back();
    if (f.more_runs == 0) return pop();
    --f.more_runs;
    ++frame_changes_;
    if (session_.pass != 0xffff) ++session_.pass;
    next_ = f.begin;
}

// ---------------------------------------------------------------- jumps and sections

void Executor::run(const program::Jump& jump) {
    const auto label = evaluator_.count(jump.label);
    if (!label) return;
    if (*label > session_.dialect.limits.label)
        return refuse(Id::jump_label_out_of_range, session_.dialect.limits.label);
    const auto target = session_.program->label(*label);
    if (!target) return refuse(Id::label_undefined, *label);
    jump_to(*target);
}

void Executor::jump_to(program::Cursor target) {
    const std::uint64_t from = session_.block->here.offset;
    if (target.offset <= from &&
        loop_.endless(session_.program->file(), from, evaluator_.changes + variables_.uses + frame_changes_)) {
        // A part program may run for ever on the control, e.g. from a bar feeder; a path without end cannot be made.
        refuse(session_.options.live_may_be_unknown ? Id::repeats_without_end : Id::endless_loop);
        ended_ = true;
        return;
    }
    while (!frames_.empty() && !contains(frames_.back(), target)) {
        session_.report_once(Id::jump_leaves_level, statement_->token, statement_->end_token);
        if (frames_.back().of_function) iso_.subroutine_ended();
        leave();
    }
    next_ = target;
}

/// Whether a jump to `target` stays inside a frame. A subroutine's end is not known; what stands before it, and the
/// main part behind local subroutines, is outside.
bool Executor::contains(const Frame& frame, program::Cursor target) {
    switch (frame.kind) {
        case Frame::Kind::section:
            return target.offset >= frame.begin.offset && target.offset < frame.end;
        case Frame::Kind::subroutine:
            return target.offset >= frame.begin.offset &&
                   (!frame.local || target.offset < session_.program->start().offset);
        case Frame::Kind::program:
            return true;
    }
    return true;
}

void Executor::run(const program::Repeat& repeat) {
    const auto first = evaluator_.count(repeat.first);
    const auto last = first ? evaluator_.count(repeat.last) : std::nullopt;
    if (!last) return;
    program::Program* in = session_.program;
    if (repeat.program.present()) {
        const auto number = evaluator_.count(repeat.program);
        if (!number) return;
        if (in->number() != *number) in = session_.library.program(*number);
        if (!in) return refuse(Id::program_cannot_run, *number);
    }
    const std::uint32_t most = session_.dialect.limits.label;
    if (*first > most || *last > most) return refuse(Id::jump_label_out_of_range, most);
    const auto begin = in->label(*first), end = in->label(*last);
    if (!begin || !end) return refuse(Id::repeat_label_undefined, begin ? *last : *first);
    if (end->offset < begin->offset) return refuse(Id::repeat_labels_reversed, *first, *last);

    const std::uint32_t count = runs();
    if (count == 0) return;
    Frame frame{.kind = Frame::Kind::section, .more_runs = count - 1};
    const program::Cursor here = session_.block->here;
    frame.end = in->read(*end)->next.offset;
    session_.block = session_.program->read(here);  // reading may have replaced the block
    const auto levels = static_cast<std::size_t>(session_.dialect.limits.subroutine_levels);
    const bool holds_itself = in == session_.program && here.offset >= begin->offset && here.offset < frame.end;
    if (holds_itself && frames_.size() >= levels) return refuse(Id::repeats_itself, *first, *last, levels);
    push(frame, *in, *begin);
}

// ---------------------------------------------------------------- subroutines

/// Nothing runs into a subroutine: it stands behind the end of the main part (8055 T 2.2, 12.5).
void Executor::run(const program::SubroutineBegin& begin) {
    refuse(begin.local ? Id::local_subroutine_after_start : Id::subroutine_in_main_part);
}

void Executor::run(const program::Return&) {
    while (!frames_.empty() && frames_.back().kind == Frame::Kind::section) leave();
    if (frames_.empty() || frames_.back().kind == Frame::Kind::program) return refuse(Id::return_alone);
    next_run();
}

/// Local subroutines are those of the root program only, and come before global ones (8055 T 2.2).
Executor::Found Executor::find(std::uint32_t number, program::Call::Kind kind) {
    using Kind = program::Call::Kind;
    if (kind != Kind::by_g_code)
        if (const auto* s = root_.subroutine(number, true)) return {&root_, s};
    if (kind == Kind::local) return {};
    for (program::Program* p : {session_.program, &root_})
        if (const auto* s = p->subroutine(number, false)) return {p, s};
    const auto found = session_.library.subroutine(number);
    return {found.program, found.subroutine};
}

void Executor::run(const program::Call& c) {
    using Kind = program::Call::Kind;
    const auto number = evaluator_.count(c.number);
    if (!number) return;
    const control::Limits& limits = session_.dialect.limits;
    const bool oem = *number >= limits.oem_subroutine_first && *number <= limits.oem_subroutine_last;
    if (oem && !session_.program->header().oem) return refuse(Id::oem_subroutine, *number);
    const Found found = find(*number, c.kind);
    if (!found.subroutine) return refuse(Id::subroutine_undefined, *number);

    // Calls that give parameters make a level of their own; CALL, LL and a bare G180 run in that of the caller.
    const bool level = c.kind == Kind::with_parameters || c.kind == Kind::modal || !c.arguments.empty();
    Arguments arguments;
    if (!take_arguments(c.arguments, arguments)) return;
    if (c.kind == Kind::modal) modal_ = ModalCall{found.program, *found.subroutine, arguments};
    call(found, level ? &arguments : nullptr, runs(), c.kind == Kind::modal);
}

/// Evaluates arguments in the caller's level; globals among them are assigned at once (8055 T 12.5).
bool Executor::take_arguments(const std::vector<program::Assignment>& list, Arguments& out) {
    for (const program::Assignment& a : list) {
        const program::Target& t = a.target;
        std::optional<std::uint32_t> local;
        if (t.kind == program::Target::Kind::letter) local = t.operand;
        if (t.kind == program::Target::Kind::parameter) local = whole_number(session_.block->slots[t.slot].value);
        if (local && *local < Parameters::local_count)
            out.set(*local, evaluator_.value(a.value));
        else
            evaluator_.assign(a);
        if (session_.ends()) return false;
    }
    return true;
}

/// With `arguments` in a new level. They are given once for all runs (8055 T 12.5: of `X10 N3` only the first of the
/// three executions gets the call parameters).
void Executor::call(const Found& found, const Arguments* arguments, std::uint32_t count, bool modal) {
    if (count == 0) return;
    const program::Subroutine& s = *found.subroutine;
    Frame frame{.own_level = arguments != nullptr,
                .modal = modal,
                .local = s.local,
                .number = s.number,
                .more_runs = count - 1};
    if (!push(frame, *found.program, s.body) || !arguments) return;
    variables_.call_parameters = arguments->given;
    for (std::uint32_t n = 0; n < Parameters::local_count; ++n) *session_.parameters.find(n) = arguments->value[n];
}

/// The subroutine of an M or T function, or of G74: like CALL (8055 T 5.7).
void Executor::call_function(std::uint32_t number) {
    const Found found = find(number, program::Call::Kind::by_g_code);
    if (!found.subroutine) return session_.report_block(Id::subroutine_undefined, number);
    push(Frame{.of_function = true, .number = number}, *found.program, found.subroutine->body);
}

void Executor::call_program(program::Program& program, bool modal) {
    push(Frame{.kind = Frame::Kind::program, .modal = modal}, program, program.start());
}

void Executor::call_modal() {
    if (!modal_->subroutine) return call_program(*modal_->program, true);  // MEXEC: a count is ignored (8055 T 12.8)
    call({modal_->program, &*modal_->subroutine}, &modal_->arguments, runs(), true);
}

void Executor::run(const program::EndModal&) {
    modal_.reset();
}

}  // namespace fagorc::passes
