// Findings of the blocks that no execution has read: an error behind a jump, or behind M30, is an error too.
#include "frontend/structure/program_text.hpp"
#include "ir/program/findings.hpp"

namespace fagorc::frontend {

using program::Block;
using program::Cursor;

void ProgramText::check_unread(diag::Sink& out) {
    read_start();
    const bool all = indexed_to_.offset > first_.offset;  // subroutines are known: their rules need the whole text
    const auto walk = [&](Cursor at, std::uint64_t end) {
        while (at.offset < end) {
            const Block* block = decode(at, looking_);
            if (!block || block->here.offset >= end) return;
            program::report_findings(*this, *block, out);
            at = block->next;
            check_subroutine(*block, out);
        }
    };
    walk(first_, mark_);
    walk(all ? *start_ : read_to_, UINT64_MAX);
    seen_subroutines_.clear();
}

/// The number of a subroutine: in range, once in the text, and not too many local ones (8055 T 12.4, 2.7).
void ProgramText::check_subroutine(const Block& block, diag::Sink& out) {
    const auto* s = std::get_if<program::Statement>(&block.shape->body);
    const auto* sub = s ? std::get_if<program::SubroutineBegin>(&s->what) : nullptr;
    if (!sub) return;
    const control::Limits& limits = decoder_.dialect.limits;
    const double number = block.slots[sub->slot].value;
    const bool oem = number >= limits.oem_subroutine_first && number <= limits.oem_subroutine_last;
    const diag::Place where = place(block, sub->token, s->end_token);
    if (number > limits.subroutine && !(oem && header().oem && !sub->local))
        out.report(diag::Id::subroutine_number_out_of_range, where, 0, limits.subroutine);
    const bool once = seen_subroutines_.emplace(sub->local, number).second;
    if (!once) out.report(diag::Id::subroutine_repeated, where, number);
    // Local ones come first in the text: no other is counted with them.
    if (once && sub->local && seen_subroutines_.size() == limits.local_subroutines + 1)
        out.report(diag::Id::too_many_local_subroutines, where, static_cast<std::uint64_t>(limits.local_subroutines));
}

}  // namespace fagorc::frontend
