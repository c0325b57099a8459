#include "exports/expression_writer.h"

#include <algorithm>
#include <numbers>

namespace rinceau {

namespace {

using Op = Expression::Op;

struct Part {
    std::string text;
    bool composite = false;
};

std::string operand_text(const Part& part) { return part.composite ? '(' + part.text + ')' : part.text; }

std::string_view common_sign(Op op) {
    switch (op) {
        case Op::add:
            return "+";
        case Op::subtract:
            return "-";
        case Op::multiply:
            return "*";
        case Op::divide:
            return "/";
        case Op::less:
            return " < ";
        case Op::less_equal:
            return " <= ";
        case Op::greater:
            return " > ";
        case Op::greater_equal:
            return " >= ";
        default:
            return {};
    }
}

std::size_t operand_count(const Expression::Node& node) {
    switch (node.op) {
        case Op::number:
        case Op::name:
            return 0;
        case Op::negate:
        case Op::logical_not:
            return 1;
        case Op::call:
            return static_cast<std::size_t>(node.arguments);
        default:
            return 2;
    }
}

std::optional<Part> name_part(const std::string& name, const ExpressionSyntax& syntax) {
    if (const std::optional<std::string> text = syntax.name(name)) return Part{*text};
    if (name == "pi") return Part{syntax.number(std::numbers::pi)};
    if (name == "e") return Part{syntax.number(std::numbers::e)};
    return std::nullopt;
}

std::optional<Part> node_part(const Expression::Node& node, const std::vector<Part>& operands,
                              const ExpressionSyntax& syntax) {
    if (node.op == Op::number) return Part{syntax.number(node.number), node.number < 0};
    if (node.op == Op::name) return name_part(node.name, syntax);
    std::vector<std::string> texts;
    for (const Part& operand : operands) texts.push_back(node.op == Op::call ? operand.text : operand_text(operand));
    const std::optional<std::string> text =
        node.op == Op::call ? syntax.call(node.name, texts) : syntax.operation(node.op, texts);
    if (!text) return std::nullopt;
    return Part{*text, true};
}

}  // namespace

std::optional<std::string> common_operation(Op op, const std::vector<std::string>& operands) {
    if (op == Op::negate) return '-' + operands[0];
    const std::string_view sign = common_sign(op);
    if (sign.empty()) return std::nullopt;
    return operands[0] + std::string(sign) + operands[1];
}

std::optional<std::string> write_expression(const Expression& expression, const ExpressionSyntax& syntax) {
    std::vector<Part> parts;
    for (const Expression::Node& node : expression.postfix) {
        const std::size_t count = operand_count(node);
        if (count > parts.size()) return std::nullopt;
        const auto first = parts.end() - static_cast<std::ptrdiff_t>(count);
        std::optional<Part> part = node_part(node, {first, parts.end()}, syntax);
        if (!part) return std::nullopt;
        parts.erase(first, parts.end());
        parts.push_back(std::move(*part));
    }
    if (parts.size() != 1) return std::nullopt;
    return parts.front().text;
}

bool calls(const Expression& expression, std::string_view function) {
    return std::ranges::any_of(expression.postfix,
                               [&](const Expression::Node& node) { return node.op == Op::call && node.name == function; });
}

}  // namespace rinceau
