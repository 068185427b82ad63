// Static types and checks of expressions (8055 T 11.4, 11.5).
#include <array>

#include "frontend/bind/binding.hpp"

namespace fagorc::frontend {

using diag::Id;
using program::Node;
using program::Operator;

namespace {

/// How many values a node takes from the stack.
int operands_of(const Node& node) {
    switch (node.op) {
        case Operator::number:
        case Operator::constant:
        case Operator::pi:
        case Operator::parameter:
        case Operator::letter:
            return 0;
        case Operator::variable:
            return node.indexed ? 1 : 0;
        case Operator::indirect:
        case Operator::entry:
        case Operator::negate:
        case Operator::not_:
        case Operator::function:
            return 1;
        case Operator::position:
        case Operator::add:
        case Operator::subtract:
        case Operator::multiply:
        case Operator::divide:
        case Operator::power:
        case Operator::modulo:
        case Operator::compare:
        case Operator::and_:
        case Operator::or_:
        case Operator::xor_:
        case Operator::arg:
            return 2;
    }
    return 0;
}

bool is_logical_operator(Operator op) {
    return op == Operator::not_ || op == Operator::and_ || op == Operator::or_ || op == Operator::xor_;
}

const control::Variable* row_of(const Binding& b, std::uint16_t payload) {
    const std::uint16_t row = control::variable_row(payload);
    return row < b.dialect.variables.size() ? &b.dialect.variables[row] : nullptr;
}

void check_read(Binding& b, const Node& node) {
    const control::Variable* v = row_of(b, node.operand);
    if (!v || v->readable) return;
    b.report(v->writable ? Id::variable_write_only : Id::variable_not_accessible, node.token, node.token + 1u,
             b.dialect.variable_name(node.operand));
}

}  // namespace

void check_expression(Binding& b, program::Expression e) {
    std::array<bool, program::max_expression_depth> condition{};  // type of each value that waits
    int depth = 0;
    for (std::size_t i = e.first; i < std::size_t{e.first} + e.count; ++i) {
        Node& node = b.out.nodes[i];
        const int operands = operands_of(node);
        bool all_conditions = operands > 0;
        for (int k = 0; k < operands; ++k)
            all_conditions = condition[static_cast<std::size_t>(--depth)] && all_conditions;
        if (depth >= program::max_expression_depth) {
            b.report(Id::expression_too_deep, e.token, e.end_token, program::max_expression_depth);
            return;
        }
        node.logical = is_logical_operator(node.op) && all_conditions;
        node.condition = node.op == Operator::compare || node.logical;
        condition[static_cast<std::size_t>(depth++)] = node.condition;
        if (node.op == Operator::variable || node.op == Operator::position) check_read(b, node);
    }
}

void check_target(Binding& b, const program::Target& target) {
    if (target.index.present()) check_expression(b, target.index);
    if (target.kind != program::Target::Kind::variable) return;
    const control::Variable* v = row_of(b, target.operand);
    if (!v || v->writable) return;
    b.report(v->readable ? Id::variable_read_only : Id::variable_not_accessible, target.token, target.token + 1u,
             b.dialect.variable_name(target.operand));
}

}  // namespace fagorc::frontend
