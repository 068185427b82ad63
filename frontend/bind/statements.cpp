// Statements of the high-level language (8055 T chapter 12).
#include "frontend/bind/binding.hpp"

namespace fagorc::frontend {

namespace {

using diag::Id;
using program::Call;
using program::Device;
using program::Keyword;
using program::StatementKind;

class StatementBinder {
  public:
    StatementBinder(Binding& binding, const syntax::Statement& statement) : b_(binding), s_(statement) {}

    program::Statement bind() {
        for (const program::Expression e : s_.operands) check_expression(b_, e);
        assignments();
        return {kind(), s_.token, s_.end_token};
    }

  private:
    /// The word of the statement as messages spell it.
    diag::Argument word() const { return b_.named(s_.token); }
    program::Expression operand(std::size_t i) const {
        return i < s_.operands.size() ? s_.operands[i] : program::Expression{};
    }
    std::uint16_t slot(std::size_t text) const { return b_.tokens[s_.texts[text]].slot; }
    void refuse(Id id) { b_.report(id, s_.token, s_.token + 1u, word()); }

    void assignments() {
        for (const program::Assignment& a : s_.assignments) {
            check_target(b_, a.target);
            check_expression(b_, a.value);
            const bool letter_n = a.target.kind == program::Target::Kind::letter && a.target.operand == 'N' - 'A';
            // N names no parameter, but a probing cycle takes it (8055 T 10.2, 11.2.1).
            if (letter_n && s_.word != Keyword::probe)
                b_.report(Id::syntax_error, a.target.token, a.target.token + 1u, 'N');
        }
        const auto most = static_cast<std::size_t>(b_.dialect.limits.assignments_per_block);
        if (s_.assignments.size() <= most) return;
        const std::uint32_t marked = s_.assignments[most].target.token;
        b_.report(Id::too_many_assignments, marked, marked + 1, most).limit = static_cast<std::uint32_t>(most);
    }

    StatementKind kind() {
        if (!s_.word) return program::Assign{s_.assignments};
        switch (*s_.word) {
            case Keyword::if_:
                return branch();
            case Keyword::goto_:
                return program::Jump{operand(0)};
            case Keyword::rpt:
                return program::Repeat{operand(0), operand(1), operand(2)};
            case Keyword::sub:
            case Keyword::lsub:
                return program::SubroutineBegin{b_.out.nodes[operand(0).first].slot, s_.word == Keyword::lsub,
                                                s_.token};
            case Keyword::ret:
                return program::Return{};
            case Keyword::ll:
                return call(Call::Kind::local);
            case Keyword::call:
                return call(Call::Kind::call);
            case Keyword::pcall:
                return call(Call::Kind::with_parameters);
            case Keyword::mcall:
                return call(Call::Kind::modal);
            case Keyword::mdoff:
                return program::EndModal{};
            case Keyword::probe:
                return program::Probe{operand(0), s_.assignments};
            case Keyword::repos:
                return reposition();
            case Keyword::exec:
            case Keyword::mexec:
                return program::Execute{operand(0), s_.names.empty() ? Device::memory : device(s_.names[0]),
                                        s_.word == Keyword::mexec};
            case Keyword::open:
                return open();
            case Keyword::write:
                if (s_.texts.empty()) refuse(Id::text_expected);
                return program::Write{s_.texts.empty() ? std::uint16_t{} : slot(0)};
            case Keyword::msg:
                if (s_.texts.empty()) refuse(Id::text_expected);
                return program::Message{s_.texts.empty() ? std::uint16_t{} : slot(0)};
            case Keyword::error:
                return error();
            case Keyword::dgwz:
                check_operand_count(b_, s_);
                return program::GraphicZone{operand(0), operand(1), operand(2), operand(3)};
            case Keyword::esblk:
            case Keyword::dsblk:
                return program::Enable{program::Enable::What::single_block, s_.word == Keyword::esblk};
            case Keyword::estop:
            case Keyword::dstop:
                return program::Enable{program::Enable::What::stop, s_.word == Keyword::estop};
            case Keyword::efhold:
            case Keyword::dfhold:
                return program::Enable{program::Enable::What::feed_hold, s_.word == Keyword::efhold};
            default:
                return bind_screen(b_, s_);
        }
    }

    StatementKind branch() {
        program::If out{operand(0), {}, {}};
        if (s_.then.empty()) b_.report(Id::if_without_action, s_.token, s_.token + 1u);
        if (s_.alternative && s_.otherwise.empty())
            b_.report(Id::if_without_action, *s_.alternative, *s_.alternative + 1u);
        for (const auto& [from, to] : {std::pair(&s_.then, &out.then), std::pair(&s_.otherwise, &out.otherwise)})
            for (const syntax::Statement& action : *from) to->push_back(bind_statement(b_, action));
        return out;
    }

    /// CALL and LL pass nothing: their subroutine sees the parameters of its caller (8055 T 12.5).
    StatementKind call(Call::Kind kind) {
        const bool passes = kind == Call::Kind::with_parameters || kind == Call::Kind::modal;
        if (!passes && !s_.assignments.empty()) {
            const std::uint32_t first = s_.assignments.front().target.token;
            b_.report(Id::parameters_not_taken, first, s_.end_token, word());
        }
        return Call{kind, operand(0), s_.assignments};
    }

    StatementKind reposition() {
        program::Reposition out;
        for (const syntax::Name& n : s_.names) {
            const auto axis = axis_of(static_cast<char>(b_.tokens[n.first].kind));
            if (axis)
                out.axes.push_back(*axis);
            else
                b_.report(Id::word_not_taken, n.first, n.end, b_.named(n.first), word());
        }
        return out;
    }

    /// The device that a name stands for; a word of letters is none (8055 T 12.8).
    Device device(const syntax::Name& name) {
        const syntax::Token& t = b_.tokens[name.first];
        if (t.kind == program::Token::keyword) {
            switch (static_cast<Keyword>(t.payload)) {
                case Keyword::device_hd:
                    return Device::disk;
                case Keyword::device_dnc2:
                    return Device::serial_pc;
                case Keyword::device_dnce:
                    return Device::ethernet_pc;
                default:
                    break;
            }
        }
        std::string spelled;
        for (std::uint32_t i = name.first; i < name.end; ++i) spelled += static_cast<char>(b_.tokens[i].kind);
        b_.report(Id::device_unknown, name.first, name.end, spelled);
        return Device::unknown;
    }

    StatementKind open() {
        program::Open out{operand(0), Device::memory, {}, {}};
        for (const syntax::Name& n : s_.names) {
            const bool one_letter = n.end - n.first == 1 && b_.tokens[n.first].kind != program::Token::keyword;
            const auto kind = b_.tokens[n.first].kind;
            if (!one_letter)
                out.device = device(n);
            else if (kind == program::letter_token('A') || kind == program::letter_token('D'))
                out.append = kind == program::letter_token('A');
            else
                b_.report(Id::append_or_delete_expected, n.first, n.end, b_.named(n.first));
        }
        if (!s_.texts.empty()) out.comment_slot = slot(0);
        return out;
    }

    StatementKind error() {
        program::ErrorStop out{operand(0), {}};
        if (!s_.texts.empty()) out.text_slot = slot(0);
        if (!out.number.present() && !out.text_slot) refuse(Id::text_expected);
        return out;
    }

    Binding& b_;
    const syntax::Statement& s_;
};

}  // namespace

program::Statement bind_statement(Binding& b, const syntax::Statement& s) {
    return StatementBinder(b, s).bind();
}

program::Statement bind_call(Binding& b, const syntax::Call& call) {
    for (const program::Assignment& a : call.arguments) check_target(b, a.target);
    const auto first = static_cast<std::uint16_t>(b.out.nodes.size());
    b.out.nodes.push_back({.op = program::Operator::constant, .operand = call.number, .token = call.token});
    const auto end = static_cast<std::uint16_t>(call.token + 1);
    return {Call{Call::Kind::by_g_code, {first, 1, call.token, end}, call.arguments}, call.token,
            static_cast<std::uint16_t>(b.tokens.size())};
}

void check_operand_count(Binding& b, const syntax::Statement& s) {
    const std::string_view word = b.dialect.word(b.tokens[s.token].kind, b.tokens[s.token].payload);
    const control::StatementRow* row = b.dialect.find_statement(word);
    if (row && !row->operands.empty() && s.operands.size() != row->operands.size())
        b.report(Id::operands_wrong, s.token, s.end_token, word, row->syntax);
}

}  // namespace fagorc::frontend
