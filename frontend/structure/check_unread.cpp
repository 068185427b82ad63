// Findings of the blocks that no execution has read: an error behind a jump, or behind M30, is an error too.
#include <algorithm>
#include <vector>

#include "frontend/structure/program_text.hpp"
#include "ir/base/whole.hpp"
#include "ir/program/findings.hpp"

namespace fagorc::frontend {

using program::Block;
using program::Cursor;

namespace {

/// The parts of a statement, and of the actions of an IF, that have limits of their own.
class Parts {
  public:
    struct Text {
        std::uint16_t slot = 0;
        const program::Statement* of = nullptr;
    };

    explicit Parts(const program::Statement& statement) { add(statement); }

    /// Whether a node is all of a label, a program or a subroutine: a number there has more digits than a constant.
    bool names(std::size_t node) const { return std::find(names_.begin(), names_.end(), node) != names_.end(); }
    /// What MSG and ERROR show.
    const std::vector<Text>& texts() const { return texts_; }

  private:
    void add(const program::Statement& s) {
        std::visit([&](const auto& what) { part(s, what); }, s.what);
    }
    void name(program::Expression e) {
        if (e.count == 1) names_.push_back(e.first);
    }

    using Whole = const program::Statement&;
    void part(Whole, const program::Jump& j) { name(j.label); }
    void part(Whole, const program::Repeat& r) {
        for (const program::Expression e : {r.first, r.last, r.program}) name(e);
    }
    void part(Whole, const program::Call& c) { name(c.number); }
    void part(Whole, const program::Execute& e) { name(e.program); }
    void part(Whole, const program::Open& o) { name(o.program); }
    void part(Whole, const program::Probe& p) { name(p.cycle); }
    void part(Whole s, const program::ErrorStop& e) {
        name(e.number);
        if (e.text_slot) texts_.push_back({*e.text_slot, &s});
    }
    void part(Whole s, const program::Message& m) { texts_.push_back({m.text_slot, &s}); }
    void part(Whole, const program::If& i) {
        for (const auto* actions : {&i.then, &i.otherwise})
            for (const program::Statement& action : *actions) add(action);
    }
    template <class Other>
    void part(Whole, const Other&) {}

    std::vector<std::size_t> names_;
    std::vector<Text> texts_;
};

}  // namespace

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

/// Constants and texts that no control takes (8055 T 11.1, alarms 0147 and 0148): execution says so of the blocks that it runs.
void ProgramText::check_limits(const Block& block, diag::Sink& out) {
    const auto* statement = std::get_if<program::Statement>(&block.shape->body);
    if (!statement) return;
    const Parts parts(*statement);
    const control::NumberFormat& format = decoder_.dialect.constant;
    for (std::size_t i = 0; i < block.shape->nodes.size(); ++i) {
        const program::Node& node = block.shape->nodes[i];
        if (node.op != program::Operator::number || parts.names(i)) continue;
        const program::Quantity& q = block.slots[node.slot];
        if (q.hexadecimal || (q.integer_digits <= format.integer_digits && q.decimals <= format.decimals_mm)) continue;
        out.report(diag::Id::number_too_long, place(block, node.token, node.token + 1u),
                   block.text.substr(q.at, q.length), format.integer_digits, format.decimals_mm);
    }
    const std::size_t most = decoder_.dialect.limits.text_length;
    for (const Parts::Text& t : parts.texts())
        if (const std::size_t length = program::text_of(block, t.slot).size(); length > most)
            out.report(diag::Id::text_too_long, place(block, t.of->token, t.of->end_token), length, most);
}

/// The number of a subroutine: in range, once in the text, and not too many local ones (8055 T 2.2, 12.5).
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
    else if (!whole_number(number))
        out.report(diag::Id::decimals_not_allowed, where, sub->local ? "LSUB" : "SUB", number);
    const bool once = seen_subroutines_.emplace(sub->local, number).second;
    if (!once) out.report(diag::Id::subroutine_repeated, where, number);
    // Local ones come first in the text: no other is counted with them.
    if (once && sub->local && seen_subroutines_.size() == limits.local_subroutines + 1)
        out.report(diag::Id::too_many_local_subroutines, where, static_cast<std::uint64_t>(limits.local_subroutines));
}

}  // namespace fagorc::frontend
