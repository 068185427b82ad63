// Postfix code read back as prefix text.
#include <fmt/format.h>

#include <vector>

#include "ir/program/describe.hpp"

namespace fagorc::program {

namespace {

std::string pop(std::vector<std::string>& stack) {
    if (stack.empty()) return "?";  // a run of nodes that is no expression
    std::string top = std::move(stack.back());
    stack.pop_back();
    return top;
}

std::string_view name_of(const Node& node) {
    switch (node.op) {
        case Operator::negate:
            return "negate";
        case Operator::not_:
            return node.logical ? "not" : "complement";
        case Operator::add:
            return "add";
        case Operator::subtract:
            return "subtract";
        case Operator::multiply:
            return "multiply";
        case Operator::divide:
            return "divide";
        case Operator::power:
            return "power";
        case Operator::modulo:
            return "modulo";
        case Operator::and_:
            return node.logical ? "and" : "bit_and";
        case Operator::or_:
            return node.logical ? "or" : "bit_or";
        case Operator::xor_:
            return node.logical ? "xor" : "bit_xor";
        case Operator::arg:
            return "arg";
        default:
            return "?";
    }
}

class ExpressionText {
  public:
    explicit ExpressionText(const control::Dialect& dialect) : dialect_(dialect) {}

    void add(const Node& node) {
        switch (node.op) {
            case Operator::number:
                return push(fmt::format("#{}", node.slot));
            case Operator::constant:
                return push(std::to_string(node.operand));
            case Operator::pi:
                return push("pi");
            case Operator::parameter:
                return push(fmt::format("P#{}", node.slot));
            case Operator::letter:
                return push(std::string(1, static_cast<char>('A' + node.operand)));
            case Operator::indirect:
                return push(fmt::format("P({})", pop(stack_)));
            case Operator::entry:
                return push(fmt::format("IB({})", pop(stack_)));
            case Operator::variable:
                return push(dialect_.variable_name(node.operand) +
                            (node.indexed ? fmt::format("({})", pop(stack_)) : std::string()));
            case Operator::position:
                return two(dialect_.variable_name(node.operand));
            case Operator::compare:
                return two(dialect_.word(Token::relation, node.operand));
            case Operator::function:
                return push(fmt::format("{}({})", dialect_.word(Token::function, node.operand), pop(stack_)));
            case Operator::negate:
            case Operator::not_:
                return push(fmt::format("{}({})", name_of(node), pop(stack_)));
            default:
                return two(name_of(node));
        }
    }
    std::string text() { return pop(stack_); }

  private:
    void push(std::string text) { stack_.push_back(std::move(text)); }
    void two(std::string_view name) {
        const std::string second = pop(stack_), first = pop(stack_);
        push(fmt::format("{}({}, {})", name, first, second));
    }

    const control::Dialect& dialect_;
    std::vector<std::string> stack_;
};

}  // namespace

std::string describe(const BlockTemplate& shape, Expression expression, const control::Dialect& dialect) {
    ExpressionText text(dialect);
    for (const Node& node : shape.run(expression)) text.add(node);
    return text.text();
}

}  // namespace fagorc::program
