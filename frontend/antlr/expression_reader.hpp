// Copies expressions from ANTLR's tree as postfix code. Only block_parser.cpp includes this file.
#pragma once

#include <Fagor8055.h>

#include <utility>

#include "frontend/antlr/tree.hpp"

namespace fagorc::frontend::tree {

using grammar::Fagor8055;
using program::Expression;
using program::Node;
using program::Operator;

/// All binary operators but the relations.
inline constexpr std::pair<std::size_t, Operator> binary_operators[] = {
    {Fagor8055::PLUS, Operator::add},       {Fagor8055::MINUS, Operator::subtract},
    {Fagor8055::TIMES, Operator::multiply}, {Fagor8055::DIVIDE, Operator::divide},
    {Fagor8055::EXP, Operator::power},      {Fagor8055::MOD, Operator::modulo},
    {Fagor8055::AND, Operator::and_},       {Fagor8055::OR, Operator::or_},
    {Fagor8055::XOR, Operator::xor_}};

/// The part of a tree reader that knows expressions.
class ExpressionReader {
  protected:
    /// An expression that covers a context and has no node yet.
    Expression open(const ParserRuleContext& c) const {
        return {static_cast<Index>(out_.nodes.size()), 0, place(c.start), end_of(c)};
    }
    /// One node more; for expressions that no rule of the grammar makes.
    void push(const Node& node, Expression& e) {
        out_.nodes.push_back(node);
        ++e.count;
    }
    Expression number(const antlr4::Token* token) {
        Expression e{static_cast<Index>(out_.nodes.size()), 0, place(token), static_cast<Index>(place(token) + 1)};
        push({.op = Operator::number, .slot = key(token).slot, .token = place(token)}, e);
        return e;
    }
    Expression expression(const ParserRuleContext& c) {
        Expression e = open(c);
        value(c);
        e.count = static_cast<Index>(out_.nodes.size() - e.first);
        return e;
    }
    /// A number, a parameter, or an expression in parentheses: the number of a label, a program, an entry of a table.
    Expression numeral(const ParserRuleContext& c) {
        if (c.children.size() == 3) return expression(rule(c, 1));
        if (c.children.size() == 1) return number(leaf(c, 0));
        Expression e = open(c);
        push({.op = Operator::parameter, .slot = key(leaf(c, 1)).slot, .token = place(c.start)}, e);
        return e;
    }

    syntax::Block out_;

  private:
    void push(const Node& node) { out_.nodes.push_back(node); }

    /// Any level of the expression grammar, which has them in a row down to unary. Those without operator are passed
    /// by.
    void value(const ParserRuleContext& of) {
        const ParserRuleContext* c = &of;
        while (c->children.size() == 1 && c->getRuleIndex() < Fagor8055::RuleUnary) c = &rule(*c, 0);
        if (c->getRuleIndex() == Fagor8055::RuleUnary) return unary(*c);
        value(rule(*c, 0));
        for (std::size_t i = 1; i < c->children.size(); i += 2) {
            value(rule(*c, i + 1));
            binary(leaf(*c, i));
        }
    }

    void binary(const antlr4::Token* token) {
        Node node{.op = binary_operator(token->getType()), .token = place(token)};
        if (node.op == Operator::compare) node.operand = key(token).payload;
        push(node);
    }

    static Operator binary_operator(std::size_t type) {
        for (const auto& [terminal, op] : binary_operators)
            if (terminal == type) return op;
        return Operator::compare;
    }

    /// Signs, NOT and functions, from the innermost outwards.
    void unary(const ParserRuleContext& c) {
        const std::size_t signs = c.children.size() - 1;
        const ParserRuleContext& operand = rule(c, signs);
        primary(operand);
        const bool plain = operand.start->getType() == Fagor8055::NUMBER || operand.start->getType() == Fagor8055::LEFT;
        for (std::size_t i = signs; i-- > 0;) {
            const antlr4::Token* token = leaf(c, i);
            if (const std::size_t type = token->getType(); type == Fagor8055::FUNCTION) {
                if (!plain) out_.bare_arguments.push_back(place(token));
                push({.op = Operator::function, .operand = key(token).payload, .token = place(token)});
            } else if (type != Fagor8055::PLUS) {
                push({.op = type == Fagor8055::NOT ? Operator::not_ : Operator::negate, .token = place(token)});
            }
        }
    }

    void primary(const ParserRuleContext& c) {
        const antlr4::Token* token = c.start;
        const Index at = place(token);
        const std::size_t n = c.children.size();
        switch (token->getType()) {
            case Fagor8055::NUMBER:
                return push({.op = Operator::number, .slot = key(token).slot, .token = at});
            case Fagor8055::PI:
                return push({.op = Operator::pi, .token = at});
            case Fagor8055::LETTER_P:
                if (n == 2) return push({.op = Operator::parameter, .slot = key(leaf(c, 1)).slot, .token = at});
                if (n == 4) {
                    value(rule(c, 2));
                    return push({.op = Operator::indirect, .token = at});
                }
                [[fallthrough]];
            case Fagor8055::LETTER:
                return push({.op = Operator::letter, .operand = static_cast<Index>(letter(token) - 'A'), .token = at});
            case Fagor8055::IB:
                numeral(rule(c, 1));
                return push({.op = Operator::entry, .token = at});
            case Fagor8055::ARG:
                value(rule(c, 2));
                value(rule(c, 4));
                return push({.op = Operator::arg, .token = at});
            case Fagor8055::LEFT:
                return value(rule(c, 1));
            default:
                return variable(rule(c, 0));
        }
    }

    void variable(const ParserRuleContext& c) {
        Node node{.op = Operator::variable, .operand = key(c.start).payload, .token = place(c.start)};
        if (c.start->getType() == Fagor8055::POSITION_VARIABLE) {
            node.op = Operator::position;
            numeral(rule(c, 2));
            numeral(rule(c, 4));
        } else if (c.children.size() > 1) {
            node.indexed = true;
            numeral(rule(c, 1));
        }
        push(node);
    }
};

}  // namespace fagorc::frontend::tree
