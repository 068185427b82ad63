#include "passes/execute/screen.hpp"

#include <algorithm>
#include <cmath>

namespace fagorc::passes {

using diag::Id;
using program::Keyword;

namespace {

/// What a constant operand out of the range of its row raises. `group`: how many operands repeat (DW1=.., DW2=..).
struct OperandCheck {
    Keyword word;
    std::size_t operand, group;
    Id id;
};

constexpr OperandCheck checks[] = {
    {Keyword::page, 0, 1, Id::page_out_of_range},     {Keyword::symbol, 0, 3, Id::symbol_out_of_range},
    {Keyword::symbol, 1, 3, Id::symbol_out_of_range}, {Keyword::symbol, 2, 3, Id::symbol_out_of_range},
    {Keyword::odw, 0, 3, Id::window_out_of_range},    {Keyword::odw, 1, 3, Id::row_out_of_range},
    {Keyword::odw, 2, 3, Id::column_out_of_range},    {Keyword::dw, 0, 2, Id::window_out_of_range},
    {Keyword::dwh, 0, 2, Id::window_out_of_range},    {Keyword::dwb, 0, 2, Id::window_out_of_range},
    {Keyword::sk, 0, 1, Id::softkey_out_of_range},    {Keyword::ib, 0, 2, Id::entry_out_of_range},
};

/// INPUT "text", 5.4: digits before and after the point; a minus admits negative values.
bool format_fits(double format) {
    const double before = std::trunc(std::abs(format)), after = std::round((std::abs(format) - before) * 10);
    return before <= 6 && after <= 5;
}

/// Pages 0 to 255 are the user's, those from 1000 on the system's (8055 T 12.9); there is none between.
bool is_no_page(Keyword word, double number) {
    return word == Keyword::page && number > 255 && number < 1000;
}

bool ends_program(const program::FunctionCall& misc) {
    return misc.number == 30 || misc.number == 2;
}

bool is_window(Keyword word) {
    return word == Keyword::dw || word == Keyword::dwh || word == Keyword::dwb;
}

}  // namespace

bool is_customisation(program::Program& program) {
    for (program::Cursor at = program.start(); const program::Block* block = program.read(at); at = block->next) {
        const auto* iso = std::get_if<program::IsoBlock>(&block->shape->body);
        if (iso && (iso->has_axis || std::any_of(iso->misc.begin(), iso->misc.end(), ends_program))) return false;
    }
    return true;
}

void ScreenChecker::check() {
    const program::BlockTemplate& shape = *session_.block->shape;
    if (const auto* statement = std::get_if<program::Statement>(&shape.body)) check(*statement);
    for (const program::Word& w : shape.words)
        if (w.value.kind == program::WordValue::Kind::parameter)
            local(session_.block->slots[w.value.slot].value, w.token);
}

void ScreenChecker::check(const program::Statement& statement) {
    if (const auto* screen = std::get_if<program::Screen>(&statement.what)) check(*screen);
    if (const auto* assign = std::get_if<program::Assign>(&statement.what)) check(assign->list);
    if (const auto* call = std::get_if<program::Call>(&statement.what)) check(call->arguments);
    if (const auto* branch = std::get_if<program::If>(&statement.what)) {
        check(branch->condition);
        for (const auto& s : branch->then) check(s);
        for (const auto& s : branch->otherwise) check(s);
    }
}

void ScreenChecker::check(const std::vector<program::Assignment>& list) {
    for (const program::Assignment& a : list) {
        if (a.target.kind == program::Target::Kind::letter) local(0, a.target.token);
        if (a.target.kind == program::Target::Kind::parameter)
            local(session_.block->slots[a.target.slot].value, a.target.token);
        check(a.target.index);
        check(a.value);
    }
}

void ScreenChecker::check(program::Expression expression) {
    for (const program::Node& n : session_.block->shape->run(expression)) {
        if (n.op == program::Operator::letter) local(0, n.token);
        if (n.op == program::Operator::parameter) local(session_.block->slots[n.slot].value, n.token);
    }
}

void ScreenChecker::local(double parameter, std::uint16_t token) {
    if (parameter < Parameters::local_count) session_.report_once(Id::local_parameter_not_allowed, token, token + 1);
}

std::optional<double> ScreenChecker::constant(program::Expression expression) const {
    const auto nodes = session_.block->shape->run(expression);
    if (nodes.empty() || nodes[0].op != program::Operator::number) return std::nullopt;
    const double value = session_.block->slots[nodes[0].slot].value;
    if (nodes.size() == 1) return value;
    return nodes.size() == 2 && nodes[1].op == program::Operator::negate ? std::optional(-value) : std::nullopt;
}

void ScreenChecker::check(const program::Screen& screen) {
    for (const program::Expression& e : screen.operands) check(e);
    const control::StatementRow* row = session_.dialect.find_statement(session_.dialect.word(screen.word));
    for (const OperandCheck& c : checks) {
        if (c.word != screen.word || !row || c.operand >= row->operands.size()) continue;
        for (std::size_t i = c.operand; i < screen.operands.size(); i += c.group) {
            const auto value = constant(screen.operands[i]);
            if (value && (!row->operands[c.operand].range.allows(*value) || is_no_page(screen.word, *value))) {
                session_.report(c.id, screen.operands[i].token, screen.operands[i].end_token, *value);
            } else if (c.operand == 0 && (screen.word == Keyword::odw || is_window(screen.word))) {
                window(value.value_or(unknown_value), screen.operands[i], screen.word == Keyword::odw);
            }
        }
    }
    if (screen.word != Keyword::ib || screen.operands.size() < 2) return;
    const auto format = constant(screen.operands[1]);
    if (format && !format_fits(*format))
        session_.report(Id::entry_format_too_large, screen.operands[1].token, screen.operands[1].end_token, *format);
}

void ScreenChecker::window(double number, program::Expression operand, bool defines) {
    if (defines) {
        any_window_ = any_window_ || is_unknown(number);
        windows_.insert(number);
    } else if (!any_window_ && !is_unknown(number) && !windows_.contains(number)) {
        session_.report(Id::window_not_defined, operand.token, operand.end_token, number);
    }
}

}  // namespace fagorc::passes
