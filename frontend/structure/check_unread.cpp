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
            check_limits(*block, out);
            check_subroutine(*block, out);
            at = block->next;
        }
    };
    walk(first_, mark_);
    walk(all ? *start_ : read_to_, UINT64_MAX);
    seen_subroutines_.clear();
}

/// Constants and texts that no control takes: execution says so of the blocks that it runs.
void ProgramText::check_limits(const Block& block, diag::Sink& out) {
    const control::NumberFormat& format = decoder_.dialect.constant;
    for (const program::Node& node : block.shape->nodes) {
        if (node.op != program::Operator::number) continue;
        const program::Quantity& q = block.slots[node.slot];
        if (q.hexadecimal || (q.integer_digits <= format.integer_digits && q.decimals <= format.decimals_mm)) continue;
        out.report(diag::Id::number_too_long, place(block, node.token, node.token + 1u),
                   block.text.substr(q.at, q.length), format.integer_digits, format.decimals_mm);
    }
    if (const auto* s = std::get_if<program::Statement>(&block.shape->body)) check_texts(block, *s, out);
}

void ProgramText::check_texts(const Block& block, const program::Statement& statement, diag::Sink& out) {
    const std::size_t most = decoder_.dialect.limits.text_length;
    const auto check = [&](std::uint16_t slot) {
        const std::size_t length = program::text_of(block, slot).size();
        if (length > most)
            out.report(diag::Id::text_too_long, place(block, statement.token, statement.end_token), length, most);
    };
    if (const auto* message = std::get_if<program::Message>(&statement.what)) check(message->text_slot);
    if (const auto* error = std::get_if<program::ErrorStop>(&statement.what); error && error->text_slot)
        check(*error->text_slot);
    if (const auto* branch = std::get_if<program::If>(&statement.what))
        for (const auto* list : {&branch->then, &branch->otherwise})
            for (const program::Statement& s : *list) check_texts(block, s, out);
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
