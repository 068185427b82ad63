// Evaluates expressions and stores assignments (8055 T 11.4, 11.5, 12.1).
#pragma once

#include <cstdint>
#include <optional>

#include "ir/program/statement.hpp"
#include "passes/execute/session.hpp"
#include "passes/execute/variables.hpp"

namespace fagorc::passes {

class Evaluator {
  public:
    Evaluator(Session& session, Variables& variables)
        : session_(session),
          variables_(variables),
          most_digits_(session.dialect.constant.integer_digits),
          most_decimals_(session.dialect.constant.decimals_mm) {}

    /// The value of an expression of the session's block; unknown when an operand is, or after an error (reported at
    /// the operand; `session.failed`).
    double value(program::Expression expression);
    /// A value that the execution cannot go on without: an unknown one blocks the path. Nothing when it ends.
    std::optional<double> known(program::Expression expression);
    /// A known number of something, whole within `index_tolerance`, from 0 to 2^32 - 1 (else alarm 0152).
    std::optional<std::uint32_t> count(program::Expression expression);

    /// Evaluates and stores assignments from left to right, so that chains on one target work (8055 T 12.1).
    void assign(const program::Assignment& assignment);
    /// The cell of the parameter that a slot names, or null (reported).
    double* parameter(double number, std::uint16_t token) { return session_.parameter(number, token, token + 1u); }

    /// Assignments that changed a value, so far.
    std::uint64_t changes = 0;

  private:
    using Node = program::Node;
    template <class... Arguments>
    double fail(const Node& node, diag::Id id, Arguments... arguments);
    double fail_too_long(const Node& node);
    bool too_long(const program::Quantity& q) const {
        return (q.integer_digits > most_digits_ || q.decimals > most_decimals_) && !q.hexadecimal;
    }
    double other(const Node& node, double*& below, double top);
    double binary(const Node& node, double a, double b);
    double power(const Node& node, double base, double exponent);
    double function(const Node& node, double a);
    double* indirect_cell(double number, std::uint16_t token);

    Session& session_;
    Variables& variables_;
    int most_digits_, most_decimals_;  ///< of a decimal constant
};

}  // namespace fagorc::passes
