#include "passes/execute/expression.hpp"

#include <array>
#include <cmath>

#include "passes/execute/bits.hpp"
#include "passes/execute/trigonometry.hpp"

namespace fagorc::passes {

using diag::Id;
using program::Function1;
using program::Operator;
using program::Relation;

template <class... Arguments>
double Evaluator::fail(const Node& node, Id id, Arguments... arguments) {
    session_.report(id, node.token, node.token + 1, arguments...);
    return unknown_value;
}

namespace {

double compare(Relation relation, double a, double b) {
    if (is_unknown(a) || is_unknown(b)) return unknown_value;
    switch (relation) {
        case Relation::eq:
            return a == b;
        case Relation::ne:
            return a != b;
        case Relation::gt:
            return a > b;
        case Relation::ge:
            return a >= b;
        case Relation::lt:
            return a < b;
        case Relation::le:
            return a <= b;
    }
    return unknown_value;
}

}  // namespace

double Evaluator::value(program::Expression expression) {
    const program::Block& block = *session_.block;
    std::array<double, program::max_expression_depth> stack;  // NOLINT: written before it is read
    double* below = stack.data();                             // one above the value under the top
    double top = 0;
    for (const Node& node : block.shape->run(expression)) {
        switch (node.op) {
            case Operator::number: {
                const program::Quantity& q = block.slots[node.slot];
                if (too_long(q)) return fail_too_long(node);
                *below++ = top;
                top = q.value;
                continue;
            }
            case Operator::parameter: {
                const double* cell = parameter(block.slots[node.slot].value, node.token);
                if (!cell) return unknown_value;
                *below++ = top;
                top = *cell;
                continue;
            }
            case Operator::letter:
                *below++ = top;
                top = *session_.parameters.find(node.operand);
                continue;
            case Operator::add:
                top = *--below + top;
                break;
            case Operator::subtract:
                top = *--below - top;
                break;
            case Operator::multiply:
                top = *--below * top;
                break;
            case Operator::compare:
                top = compare(static_cast<Relation>(node.operand), *--below, top);
                continue;
            case Operator::function:
                top = function(node, top);
                break;
            default:
                top = other(node, below, top);
                break;
        }
        if (std::isfinite(top)) continue;
        // Finite operands must not become infinite: infinity minus infinity would pass for an unknown value.
        if (std::isinf(top)) return fail(node, Id::result_not_a_number);
        if (session_.failed) return unknown_value;
    }
    return top;
}

/// A constant beyond 6.5 must be written in hexadecimal or computed (8055 T 11.3).
double Evaluator::fail_too_long(const Node& node) {
    const program::Quantity& q = session_.block->slots[node.slot];
    const control::NumberFormat& format = session_.dialect.constant;
    return fail(node, Id::number_too_long, session_.block->text.substr(q.at, q.length), format.integer_digits,
                format.decimals_mm);
}

/// The less frequent nodes. `below` is one above the value under `top`.
double Evaluator::other(const Node& node, double*& below, double top) {
    switch (node.op) {
        case Operator::pi:
            *below++ = top;
            return std::numbers::pi;
        case Operator::constant:
            *below++ = top;
            return node.operand;
        case Operator::entry:
            return variables_.entry(top, node.token);
        case Operator::negate:
            return -top;
        case Operator::not_:
            return bits::not_(top, node.logical);
        case Operator::indirect: {
            const double* cell = is_unknown(top) ? &unknown_value : indirect_cell(top, node.token);
            return cell ? *cell : unknown_value;
        }
        case Operator::variable:
            if (node.indexed) return variables_.read(node.operand, top, node.token);
            *below++ = top;
            return variables_.read(node.operand, {}, node.token);
        case Operator::position:
            return variables_.position(node.operand, *--below, top, node.token);
        default:
            return binary(node, *--below, top);
    }
}

double Evaluator::binary(const Node& node, double a, double b) {
    switch (node.op) {
        case Operator::divide:
            return b == 0 ? fail(node, Id::division_by_zero) : a / b;
        case Operator::modulo:  // the sign of the dividend, as a truncated quotient leaves it
            return b == 0 ? fail(node, Id::division_by_zero) : std::fmod(a, b);
        case Operator::power:
            return power(node, a, b);
        case Operator::and_:
            return bits::and_(a, b, node.logical);
        case Operator::or_:
            return bits::or_(a, b, node.logical);
        case Operator::xor_:
            return bits::xor_(a, b, node.logical);
        case Operator::arg:
            if (a == 0 && b == 0) return fail(node, Id::result_not_a_number);
            return is_unknown(a) || is_unknown(b) ? unknown_value : trigonometry::of_point(a, b);
        default:
            return unknown_value;
    }
}

double Evaluator::power(const Node& node, double base, double exponent) {
    if (is_unknown(base) || is_unknown(exponent)) return unknown_value;  // pow(NaN, 0) is 1
    if (base == 0 && exponent <= 0) return fail(node, Id::power_of_zero, exponent);
    if (base < 0 && exponent != std::trunc(exponent)) return fail(node, Id::power_of_negative, base, exponent);
    return std::pow(base, exponent);
}

double Evaluator::function(const Node& node, double a) {
    switch (static_cast<Function1>(node.operand)) {
        case Function1::sin:
            return trigonometry::sine(a);
        case Function1::cos:
            return trigonometry::cosine(a);
        case Function1::tan: {
            const double t = trigonometry::tangent(a);
            return std::isinf(t) ? fail(node, Id::division_by_zero) : t;
        }
        case Function1::asin:
            return std::abs(a) > 1 ? fail(node, Id::arc_function_range, "ASIN", a) : trigonometry::arc_sine(a);
        case Function1::acos:
            return std::abs(a) > 1 ? fail(node, Id::arc_function_range, "ACOS", a) : trigonometry::arc_cosine(a);
        case Function1::atan:
            return trigonometry::arc_tangent(a);
        case Function1::abs:
            return std::abs(a);
        case Function1::log:
            return a <= 0 ? fail(node, Id::logarithm_of_nothing, a) : std::log10(a);
        case Function1::sqrt:
            return a < 0 ? fail(node, Id::root_of_negative, a) : std::sqrt(a);
        case Function1::round:
            return std::round(a);  // halves away from zero
        case Function1::fix:
            return std::trunc(a);
        case Function1::fup:
            return std::ceil(a);
        case Function1::bcd: {
            const auto packed = bits::bcd(a);
            return packed ? *packed : fail(node, Id::parameter_value_unfit, "BCD", a);
        }
        case Function1::bin:
            return bits::bin(a);
    }
    return unknown_value;
}

double* Evaluator::indirect_cell(double number, std::uint16_t token) {
    if (const auto n = whole_number(number, index_tolerance)) return parameter(*n, token);
    session_.report(Id::parameter_does_not_exist, token, token + 1, number);
    return nullptr;
}

std::optional<double> Evaluator::known(program::Expression expression) {
    const double v = value(expression);
    if (session_.failed) return std::nullopt;
    if (!is_unknown(v)) return v;
    session_.blocked = true;
    return std::nullopt;
}

std::optional<std::uint32_t> Evaluator::count(program::Expression expression) {
    const auto nodes = session_.block->shape->run(expression);
    // Mostly a number: a label has more digits than a value may have.
    const bool plain = nodes.size() == 1 && nodes[0].op == Operator::number;
    const auto v = plain ? std::optional(session_.block->slots[nodes[0].slot].value) : known(expression);
    if (!v) return std::nullopt;
    if (const auto n = whole_number(*v, plain ? 0 : index_tolerance)) return n;
    const Id wrong = *v < 0                 ? Id::negative_not_allowed
                     : *v != std::trunc(*v) ? Id::decimals_not_allowed
                                            : Id::number_too_large;
    session_.report(wrong, expression.token, expression.end_token,
                    session_.text(expression.token, expression.end_token), *v);
    return std::nullopt;
}

void Evaluator::assign(const program::Assignment& assignment) {
    const program::Target& target = assignment.target;
    const double v = value(assignment.value);
    if (session_.failed) return;
    double* cell = nullptr;
    switch (target.kind) {
        case program::Target::Kind::parameter:
            cell = parameter(session_.block->slots[target.slot].value, target.token);
            break;
        case program::Target::Kind::letter:
            cell = session_.parameters.find(target.operand);
            break;
        case program::Target::Kind::indirect:
            if (const auto number = known(target.index)) cell = indirect_cell(*number, target.token);
            break;
        case program::Target::Kind::variable: {
            std::optional<double> index;
            if (target.index.present()) index = value(target.index);
            if (!session_.failed) variables_.write(target.operand, index, v, target.token);
            ++changes;
            return;
        }
    }
    if (!cell) return;
    changes += *cell != v;
    *cell = v;
}

}  // namespace fagorc::passes
