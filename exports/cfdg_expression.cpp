#include "exports/cfdg_expression.h"

#include <algorithm>
#include <numbers>
#include <vector>

#include "exports/number.h"

namespace rinceau {

namespace {

using Op = Expression::Op;
constexpr std::size_t longest_text = 4000;

std::string operand(const CfdgText& text) { return as_operand(as_number(text)); }

CfdgText compound(std::string text) { return {std::move(text), false, false}; }
CfdgText condition(std::string text) { return {std::move(text), false, true}; }
CfdgText call(const std::string& name, const std::string& arguments) { return {name + '(' + arguments + ')', true, false}; }

std::string plain(const CfdgText& text) { return as_number(text).text; }

CfdgText name_text(const std::string& name, const NameMap& names) {
    const auto found = names.find(name);
    if (found != names.end()) return {found->second};
    if (name == "pi") return {number_of(std::numbers::pi)};
    if (name == "e") return {number_of(std::numbers::e)};
    return {name};
}

/// From the last to the first, as their functions take two numbers.
CfdgText nested(const std::string& name, const std::vector<CfdgText>& arguments) {
    std::string text = plain(arguments.back());
    for (std::size_t i = arguments.size() - 1; i-- > 0;) text = name + '(' + plain(arguments[i]) + ", " + text + ')';
    return {text, arguments.size() > 1 || arguments.back().atom, false};
}

/// Functions that Context Free has under another name, or not at all.
CfdgText function_text(const std::string& name, const std::vector<CfdgText>& arguments) {
    const std::string a = operand(arguments.front());
    const std::string b = arguments.size() > 1 ? operand(arguments[1]) : "";
    if (name == "min" || name == "max") return nested(name, arguments);
    if (name == "ceil") return call("ceiling", plain(arguments[0]));
    if (name == "round") return call("if", a + " < 0, -floor(0.5 - " + a + "), floor(" + a + " + 0.5)");
    if (name == "trunc") return call("if", a + " < 0, -floor(-" + a + "), floor(" + a + ")");
    if (name == "sign") return call("if", a + " > 0, 1, if(" + a + " < 0, -1, 0)");
    if (name == "pow") return compound(a + '^' + b);
    if (name == "hypot") return call("sqrt", a + '*' + a + " + " + b + '*' + b);
    if (name == "if")
        return call("if", as_condition(arguments[0]) + ", " + plain(arguments[1]) + ", " + plain(arguments[2]));
    if (name == "clamp") return call("min", "max(" + plain(arguments[0]) + ", " + b + "), " + plain(arguments[2]));
    if (name == "uniform") return call("rand", plain(arguments[0]) + ", " + plain(arguments[1]));
    // Box and Muller's way from even to normal
    if (name == "normal") return compound(a + " + " + b + "*sqrt(-2*log(rand()))*cos(360*rand())");
    std::string list;
    for (const CfdgText& argument : arguments) list += (list.empty() ? "" : ", ") + plain(argument);
    return call(name, list);
}

CfdgText binary_text(Op op, const CfdgText& left, const CfdgText& right) {
    const std::string a = operand(left);
    const std::string b = operand(right);
    switch (op) {
        case Op::add:
            return compound(a + " + " + b);
        case Op::subtract:
            return compound(a + " - " + b);
        case Op::multiply:
            return compound(a + '*' + b);
        case Op::divide:
            return compound(a + '/' + b);
        case Op::modulo:  // with the sign of b
            return compound(a + " - " + b + "*floor(" + a + '/' + b + ')');
        case Op::power:
            return compound(a + '^' + b);
        case Op::less:
            return condition(a + " < " + b);
        case Op::less_equal:
            return condition(a + " <= " + b);
        case Op::greater:
            return condition(a + " > " + b);
        case Op::greater_equal:
            return condition(a + " >= " + b);
        case Op::equal:
            return condition(a + " == " + b);
        case Op::not_equal:
            return condition(a + " <> " + b);
        case Op::logical_and:
            return condition('(' + as_condition(left) + ") && (" + as_condition(right) + ')');
        default:
            return condition('(' + as_condition(left) + ") || (" + as_condition(right) + ')');
    }
}

}  // namespace

CfdgText as_number(const CfdgText& text) { return text.truth ? CfdgText{"if(" + text.text + ", 1, 0)", true, false} : text; }

std::string as_condition(const CfdgText& text) { return text.truth ? text.text : as_operand(text) + " <> 0"; }

std::string as_operand(const CfdgText& text) {
    const bool bare = text.atom && !text.text.starts_with('-');
    return bare ? text.text : '(' + text.text + ')';
}

std::optional<CfdgText> cfdg_expression(const Expression& expression, const NameMap& names) {
    std::vector<CfdgText> stack;
    const auto pop = [&] {
        CfdgText top = std::move(stack.back());
        stack.pop_back();
        return top;
    };
    for (const Expression::Node& node : expression.postfix) {
        if (node.op == Op::number) {
            stack.push_back({number_of(node.number)});
        } else if (node.op == Op::name) {
            stack.push_back(name_text(node.name, names));
        } else if (node.op == Op::negate) {
            stack.push_back(compound('-' + operand(pop())));
        } else if (node.op == Op::logical_not) {
            stack.push_back(condition("!(" + as_condition(pop()) + ')'));
        } else if (node.op == Op::call) {
            const auto count = static_cast<std::ptrdiff_t>(node.arguments);
            const std::vector<CfdgText> arguments(stack.end() - count, stack.end());
            stack.resize(stack.size() - arguments.size());
            stack.push_back(function_text(node.name, arguments));
        } else {
            const CfdgText right = pop();
            const CfdgText left = pop();
            stack.push_back(binary_text(node.op, left, right));
        }
        if (stack.back().text.size() > longest_text) return std::nullopt;
    }
    return stack.back();
}

}  // namespace rinceau
