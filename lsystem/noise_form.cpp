#include "lsystem/noise_form.h"

#include <algorithm>
#include <array>
#include <vector>

namespace rinceau {

namespace {

using Op = Expression::Op;
using Nodes = std::vector<Expression::Node>;

/// What follows the expression in postfix form; the deviation is a number in `deviation_at`.
struct NoiseForm {
    NoiseKind kind;
    Nodes nodes;
    std::size_t deviation_at;
};

Expression::Node number(double value) { return {Op::number, value, {}, 0}; }
Expression::Node call(const char* name, int arguments) { return {Op::call, 0, name, arguments}; }
Expression::Node operation(Op op) { return {op, 0, {}, 0}; }

std::array<NoiseForm, 3> noise_forms() {
    return {
        NoiseForm{NoiseKind::angle, {number(0), number(0), call("normal", 2), operation(Op::add)}, 1},
        NoiseForm{NoiseKind::distance,
                  {number(1), number(0), number(0), call("normal", 2), operation(Op::add), operation(Op::multiply)},
                  2},
        NoiseForm{NoiseKind::scale, {number(0), number(0), call("normal", 2), call("exp", 1), operation(Op::multiply)}, 1}};
}

bool ends_in(const Nodes& nodes, const NoiseForm& form) {
    if (nodes.size() <= form.nodes.size()) return false;
    const std::size_t start = nodes.size() - form.nodes.size();
    for (std::size_t i = 0; i < form.nodes.size(); ++i) {
        const Expression::Node& node = nodes[start + i];
        if (i == form.deviation_at ? node.op != Op::number : !(node == form.nodes[i])) return false;
    }
    return true;
}

}  // namespace

std::optional<NoiseInExpression> find_noise(const Expression& expression) {
    for (const NoiseForm& form : noise_forms()) {
        if (!ends_in(expression.postfix, form)) continue;
        const std::size_t base = expression.postfix.size() - form.nodes.size();
        const std::size_t place = base + form.deviation_at;
        return NoiseInExpression{form.kind, static_cast<int>(base), static_cast<int>(place),
                                 expression.postfix[place].number};
    }
    return std::nullopt;
}

Expression with_noise(const Expression& expression, NoiseKind kind, double deviation) {
    Expression result = expression;
    for (NoiseForm form : noise_forms()) {
        if (form.kind != kind) continue;
        form.nodes[form.deviation_at].number = deviation;
        result.postfix.insert(result.postfix.end(), form.nodes.begin(), form.nodes.end());
    }
    return result;
}

Expression without_noise(const Expression& expression) {
    Expression result = expression;
    while (const auto noise = find_noise(result)) result.postfix.resize(static_cast<std::size_t>(noise->base_size));
    return result;
}

bool is_random(const Expression& expression) {
    return std::ranges::any_of(expression.postfix, [](const Expression::Node& node) {
        return node.op == Op::call && (node.name == "normal" || node.name == "uniform");
    });
}

namespace {

/// The argument of a command that is noise and nothing else; the deviation is a number in `deviation_at`.
struct CommandForm {
    NoiseCommand noise;
    const char* symbol;
    Nodes nodes;
    std::size_t deviation_at;
};

std::array<CommandForm, 4> command_forms() {
    const Nodes angle{number(0), number(0), call("normal", 2)};
    const Nodes scale{number(0), number(0), call("normal", 2), call("exp", 1)};
    const Nodes inverse{number(1), number(0), number(0), call("normal", 2), call("exp", 1), operation(Op::divide)};
    return {
        CommandForm{{NoiseKind::angle, 0, false}, "+", angle, 1}, CommandForm{{NoiseKind::angle, 0, true}, "-", angle, 1},
        CommandForm{{NoiseKind::scale, 0, false}, "*", scale, 1}, CommandForm{{NoiseKind::scale, 0, true}, "*", inverse, 2}};
}

}  // namespace

ModuleTemplate noise_command(const NoiseCommand& noise) {
    for (CommandForm form : command_forms()) {
        if (form.noise.kind != noise.kind || form.noise.bracketed != noise.bracketed) continue;
        form.nodes[form.deviation_at].number = noise.deviation;
        return {form.symbol, {Expression{form.nodes}}, {}};
    }
    return {};
}

std::optional<NoiseCommand> find_noise_command(const ModuleTemplate& module) {
    if (module.arguments.size() != 1) return {};
    const Nodes& nodes = module.arguments.front().postfix;
    for (CommandForm form : command_forms()) {
        if (module.symbol != form.symbol || nodes.size() != form.nodes.size()) continue;
        if (nodes[form.deviation_at].op != Op::number) continue;
        form.noise.deviation = nodes[form.deviation_at].number;
        form.nodes[form.deviation_at].number = form.noise.deviation;
        if (nodes == form.nodes) return form.noise;
    }
    return {};
}

}  // namespace rinceau
