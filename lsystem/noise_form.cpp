#include "lsystem/noise_form.h"

#include <algorithm>
#include <array>
#include <vector>

namespace rinceau {

namespace {

using Op = Expression::Op;
using Nodes = std::vector<Expression::Node>;

Expression::Node number(double value) { return {Op::number, value, {}, 0}; }
Expression::Node call(const char* name, int arguments) { return {Op::call, 0, name, arguments}; }
Expression::Node operation(Op op) { return {op, 0, {}, 0}; }

/// Nodes about a draw: normal(0, s) or uniform(-s, s).
struct Form {
    Nodes nodes;
    NoiseDistribution distribution = NoiseDistribution::normal;
    std::size_t draw_at = 0;  ///< the first argument of the draw; s is the second

    std::size_t spread_at() const { return draw_at + 1; }
    int negative_at(std::size_t start) const {
        return distribution == NoiseDistribution::uniform ? static_cast<int>(start + draw_at) : -1;
    }
};

Form form(Nodes before, NoiseDistribution distribution, const Nodes& behind) {
    Form result{std::move(before), distribution, 0};
    result.draw_at = result.nodes.size();
    const bool normal = distribution == NoiseDistribution::normal;
    for (const Expression::Node& node : {number(0), number(0), call(normal ? "normal" : "uniform", 2)})
        result.nodes.push_back(node);
    result.nodes.insert(result.nodes.end(), behind.begin(), behind.end());
    return result;
}

Nodes with_spread(const Form& form, double spread) {
    Nodes nodes = form.nodes;
    nodes[form.spread_at()].number = spread;
    if (form.distribution == NoiseDistribution::uniform) nodes[form.draw_at].number = -spread;
    return nodes;
}

/// The spread, if the nodes from `start` on are of the form.
std::optional<double> spread_in(const Nodes& nodes, std::size_t start, const Form& form) {
    if (nodes.size() != start + form.nodes.size()) return {};
    const Expression::Node& spread = nodes[start + form.spread_at()];
    if (spread.op != Op::number) return {};
    for (std::size_t i = 0; i < form.nodes.size(); ++i) {
        const Expression::Node& node = nodes[start + i];
        if (i == form.spread_at()) continue;
        if (i == form.draw_at && form.distribution == NoiseDistribution::uniform) {
            if (node.op != Op::number || node.number != -spread.number) return {};
        } else if (!(node == form.nodes[i])) {
            return {};
        }
    }
    return spread.number;
}

constexpr std::array both_distributions{NoiseDistribution::normal, NoiseDistribution::uniform};

/// What follows the expression in postfix form.
struct NoiseExpressionForm {
    NoiseKind kind;
    Form form;
};

const std::vector<NoiseExpressionForm>& expression_forms() {
    static const std::vector<NoiseExpressionForm> forms = [] {
        std::vector<NoiseExpressionForm> all;
        for (const NoiseDistribution distribution : both_distributions) {
            const Nodes sum{operation(Op::add)};
            const Nodes factor{operation(Op::add), operation(Op::multiply)};
            const Nodes power{call("exp", 1), operation(Op::multiply)};
            all.push_back({NoiseKind::angle, form({}, distribution, sum)});
            all.push_back({NoiseKind::distance, form({number(1)}, distribution, factor)});
            all.push_back({NoiseKind::scale, form({}, distribution, power)});
        }
        return all;
    }();
    return forms;
}

/// The argument of a command that is noise and nothing else.
struct CommandForm {
    NoiseCommand command;
    const char* symbol;
    Form form;
};

const std::vector<CommandForm>& command_forms() {
    static const std::vector<CommandForm> forms = [] {
        std::vector<CommandForm> all;
        for (const NoiseDistribution distribution : both_distributions) {
            const Form angle = form({}, distribution, {});
            const Form scale = form({}, distribution, {call("exp", 1)});
            const Form inverse = form({number(1)}, distribution, {call("exp", 1), operation(Op::divide)});
            const Noise none{distribution, 0};
            all.push_back({{NoiseKind::angle, none, false}, "+", angle});
            all.push_back({{NoiseKind::angle, none, true}, "-", angle});
            all.push_back({{NoiseKind::scale, none, false}, "*", scale});
            all.push_back({{NoiseKind::scale, none, true}, "*", inverse});
        }
        return all;
    }();
    return forms;
}

}  // namespace

std::optional<NoiseInExpression> find_noise(const Expression& expression) {
    const Nodes& nodes = expression.postfix;
    for (const auto& [kind, form] : expression_forms()) {
        if (nodes.size() <= form.nodes.size()) continue;
        const std::size_t base = nodes.size() - form.nodes.size();
        const auto spread = spread_in(nodes, base, form);
        if (!spread) continue;
        return NoiseInExpression{kind,
                                 {form.distribution, *spread},
                                 static_cast<int>(base),
                                 static_cast<int>(base + form.spread_at()),
                                 form.negative_at(base)};
    }
    return std::nullopt;
}

Expression with_noise(const Expression& expression, NoiseKind kind, const Noise& noise) {
    Expression result = expression;
    for (const NoiseExpressionForm& known : expression_forms()) {
        if (known.kind != kind || known.form.distribution != noise.distribution) continue;
        const Nodes nodes = with_spread(known.form, noise.spread);
        result.postfix.insert(result.postfix.end(), nodes.begin(), nodes.end());
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

ModuleTemplate noise_command(const NoiseCommand& noise) {
    for (const CommandForm& known : command_forms()) {
        const bool same = known.command.kind == noise.kind && known.command.bracketed == noise.bracketed;
        if (!same || known.form.distribution != noise.noise.distribution) continue;
        return {known.symbol, {Expression{with_spread(known.form, noise.noise.spread)}}, {}};
    }
    return {};
}

std::optional<FoundNoiseCommand> find_noise_command(const ModuleTemplate& module) {
    if (module.arguments.size() != 1) return {};
    for (const CommandForm& known : command_forms()) {
        if (module.symbol != known.symbol) continue;
        const auto spread = spread_in(module.arguments.front().postfix, 0, known.form);
        if (!spread) continue;
        FoundNoiseCommand found{known.command, static_cast<int>(known.form.spread_at()), known.form.negative_at(0)};
        found.command.noise.spread = *spread;
        return found;
    }
    return {};
}

}  // namespace rinceau
