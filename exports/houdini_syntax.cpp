#include "exports/houdini_syntax.h"

#include <algorithm>

#include "exports/plain_decimal.h"

namespace rinceau {

namespace {

using Op = Expression::Op;
using Texts = std::vector<std::string>;

std::string unequal(const Texts& operands) {
    return '(' + operands[0] + '<' + operands[1] + ")|(" + operands[0] + '>' + operands[1] + ')';
}

std::optional<std::string> arithmetic(Op op, const Texts& operands) {
    switch (op) {
        case Op::add:
        case Op::subtract:
        case Op::multiply:
        case Op::divide:
        case Op::negate:
            return common_operation(op, operands);
        case Op::power:
            return operands[0] + '^' + operands[1];
        default:
            return std::nullopt;
    }
}

std::optional<std::string> logic(Op op, const Texts& operands) {
    switch (op) {
        case Op::less:
            return operands[0] + '<' + operands[1];
        case Op::greater:
            return operands[0] + '>' + operands[1];
        case Op::less_equal:
            return "!(" + operands[0] + '>' + operands[1] + ')';
        case Op::greater_equal:
            return "!(" + operands[0] + '<' + operands[1] + ')';
        case Op::not_equal:
            return unequal(operands);
        case Op::equal:
            return "!(" + unequal(operands) + ')';
        case Op::logical_and:
            return operands[0] + '&' + operands[1];
        case Op::logical_or:
            return operands[0] + '|' + operands[1];
        case Op::logical_not:
            return '!' + operands[0];
        default:
            return arithmetic(op, operands);
    }
}

std::string nested(const std::string& function, const Texts& arguments) {
    std::string text = arguments.front();
    for (std::size_t i = 1; i < arguments.size(); ++i) text = function + '(' + text + ',' + arguments[i] + ')';
    return text;
}

std::optional<std::string> call(std::string_view function, const Texts& a) {
    if (function == "min" || function == "max") return nested(std::string(function), a);
    if (function == "abs") return "max(" + a[0] + ",-(" + a[0] + "))";
    if (function == "clamp") return "min(max(" + a[0] + ',' + a[1] + ")," + a[2] + ')';
    if (function == "pow") return '(' + a[0] + ")^(" + a[1] + ')';
    if (function == "sqrt") return '(' + a[0] + ")^0.5";
    return std::nullopt;
}

std::string number(double value) { return plain_decimal(value); }

}  // namespace

ExpressionSyntax houdini_argument_syntax() { return {.number = number, .operation = arithmetic, .call = call}; }

ExpressionSyntax houdini_condition_syntax() { return {.number = number, .operation = logic, .call = call}; }

}  // namespace rinceau
