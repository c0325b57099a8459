#pragma once
// Expressions in the syntax of another language. Internal to the folder.

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lsystem/expression.h"

namespace rinceau {

/// Operands come as text that can stand beside any operator.
struct ExpressionSyntax {
    std::function<std::string(double)> number;
    /// A parameter or a constant; nothing = neither.
    std::function<std::optional<std::string>(std::string_view name)> name;
    /// Operators with one or two operands (Op::negate to Op::logical_or); nothing = the language lacks it.
    std::function<std::optional<std::string>(Expression::Op, const std::vector<std::string>&)> operation;
    std::function<std::optional<std::string>(std::string_view function, const std::vector<std::string>&)> call;
};

/// "a + b" for the operators that nearly all languages write alike: + - * / < <= > >= and the unary minus. Nothing for
/// others.
std::optional<std::string> common_operation(Expression::Op op, const std::vector<std::string>& operands);

/// The expression, or nothing where the language lacks an operator or a function. Composite operands are in parentheses, so
/// that no precedence is relied on; pi and e are written as numbers.
std::optional<std::string> write_expression(const Expression& expression, const ExpressionSyntax& syntax);

/// Does it call a function of this name?
bool calls(const Expression& expression, std::string_view function);

}  // namespace rinceau
