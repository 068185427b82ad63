// Which codes and words may stand in one block, and whether codes have the operands that they need (8055 T 5.1).
#include <array>

#include "frontend/bind/binding.hpp"

namespace fagorc::frontend {

namespace {

using control::Company;
using control::Construct;
using control::Need;
using control::Operand;
using diag::Id;
using program::FunctionCall;
using program::IsoBlock;

class CompanyCheck {
  public:
    CompanyCheck(Binding& binding, const IsoBlock& block) : b_(binding), block_(block) {
        for (const auto* list : {&block.modal, &block.functions, &block.misc})
            for (const FunctionCall& c : *list) calls_.push_back(&c);
    }

    void check() {
        misc_count();
        for (const FunctionCall* c : calls_)
            if (c->construct && !company(*c)) return;
        tool_change();
        groups();
    }

  private:
    /// Whether the block holds more than this code with its words.
    bool others() const {
        return calls_.size() > 1 || block_.geometry.count != 0 || block_.feed || block_.speed || block_.tool ||
               block_.offset || !block_.misc_by_parameter.empty();
    }

    /// False when the code has been refused.
    bool company(const FunctionCall& call) {
        const std::uint32_t first = call.token, end = call.token + 1u;
        switch (call.construct->company) {
            case Company::any:
                return true;
            case Company::alone_without_operands:
                if (call.words.count != 0) return true;
                [[fallthrough]];
            case Company::alone:
                if (!others()) return true;
                b_.report(Id::must_be_alone, first, end, call.construct->code);
                return false;
            case Company::alone_expected:
                if (others()) b_.report(Id::alone_expected, first, end, call.construct->code);
                return true;
            case Company::no_other_g:
                for (const FunctionCall* other : calls_) {
                    if (other == &call || !other->construct || other->construct->letter != 'G') continue;
                    b_.report(Id::incompatible_g, first, end, call.construct->code, other->construct->code);
                    return false;
                }
                return true;
        }
        return true;
    }

    /// Two codes of one group exclude each other; the same code twice is a repetition.
    void groups() {
        std::array<const FunctionCall*, static_cast<std::size_t>(program::Group::count_)> member{};
        for (const FunctionCall& call : block_.modal) {
            const FunctionCall*& first = member[static_cast<std::size_t>(call.construct->group)];
            if (!first)
                first = &call;
            else if (first->construct == call.construct)
                b_.report(Id::repeated_word, call.token, call.token + 1u, call.construct->code);
            else
                b_.report(Id::incompatible_g, call.token, call.token + 1u, first->construct->code,
                          call.construct->code);
        }
    }

    void misc_count() {
        const auto most = static_cast<std::size_t>(b_.dialect.limits.misc_per_block);
        if (block_.misc.size() + block_.misc_by_parameter.size() <= most) return;
        const std::uint32_t marked =
            block_.misc.size() > most ? block_.misc[most].token : block_.misc_by_parameter.back().token;
        b_.report(Id::too_many_misc, marked, marked + 1, most);
    }

    /// T with the code of the tool change admits nothing else (8055 T 5.7.6).
    void tool_change() {
        if (!block_.tool) return;
        for (const FunctionCall& m : block_.misc) {
            const bool changes =
                m.construct && m.construct->make && std::holds_alternative<program::ToolChange>(m.construct->make());
            const auto other = changes ? first_beside(m) : std::nullopt;
            if (other) b_.report(Id::tool_change_not_alone, *other, *other + 1u, b_.named(*other));
        }
    }

    /// The token of the first word beside T and the code given.
    std::optional<std::uint32_t> first_beside(const FunctionCall& code) const {
        std::optional<std::uint32_t> first;
        const auto note = [&](std::uint32_t token) { first = std::min(first.value_or(token), token); };
        for (const FunctionCall* c : calls_)
            if (c != &code) note(c->token);
        for (const program::Word& w : b_.out.run(block_.geometry)) note(w.token);
        for (const auto* w : {&block_.feed, &block_.speed, &block_.offset})
            if (*w) note((*w)->token);
        for (const program::Word& w : block_.misc_by_parameter) note(w.token);
        return first;
    }

    Binding& b_;
    const IsoBlock& block_;
    std::vector<const FunctionCall*> calls_;
};

/// Whether all operands are there that a code must have.
bool complete(const Construct& row, std::span<const program::Word> words) {
    int together = 0, together_given = 0, alternatives = 0, alternatives_given = 0;
    for (const Operand& o : row.operands) {
        const auto n = std::count_if(words.begin(), words.end(),
                                     [&](const program::Word& w) { return row.operand(w.address) == &o; });
        if (o.need == Need::required && n == 0) return false;
        if (o.need == Need::together) ++together, together_given += n != 0;
        if (o.need == Need::alternative) ++alternatives, alternatives_given += n != 0;
        if (o.address == control::any_axis && n != 0 && (n < row.least_axes || n > row.most_axes)) return false;
    }
    if (together_given != 0 && together_given != together) return false;
    return alternatives == 0 || alternatives_given == 1;
}

}  // namespace

void check_company(Binding& b, const IsoBlock& block) {
    CompanyCheck(b, block).check();
}

void check_operands(Binding& b, const FunctionCall& call) {
    const Construct* row = call.construct;
    if (!row || row->takes == control::Takes::motion || row->operands.empty()) return;
    if (!complete(*row, b.out.run(call.words)))
        b.report(row->misuse, call.token, call.token + 1u, row->code, row->syntax);
}

}  // namespace fagorc::frontend
