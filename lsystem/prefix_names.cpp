#include "lsystem/prefix_names.h"

#include <algorithm>
#include <unordered_set>

#include "lsystem/expression_functions.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

using Op = Expression::Op;

class Prefixer {
  public:
    Prefixer(const Grammar& grammar, const std::string& prefix) : prefix_(prefix + '_') {
        for (const Constant& constant : grammar.constants) constants_.insert(constant.name);
    }

    void rename(Grammar& grammar) const {
        for (Constant& constant : grammar.constants) {
            constant.name = prefix_ + constant.name;
            rename(constant.value, {});
        }
        rename(grammar.axiom, {});
        for (Production& production : grammar.productions) rename(production);
        for (Exception& exception : grammar.exceptions) rename(exception.successor, {});
        for (Terminal& terminal : grammar.terminals) rename(terminal.symbol);
        for (std::string& symbol : grammar.ignored) rename(symbol);
    }

  private:
    using Parameters = std::unordered_set<std::string>;

    std::string prefix_;
    std::unordered_set<std::string> constants_;

    void rename(std::string& symbol) const {
        if (find_turtle_command(symbol) == nullptr) symbol = prefix_ + symbol;
    }

    void rename(Expression& expression, const Parameters& parameters) const {
        for (Expression::Node& node : expression.postfix) {
            if (node.op != Op::name || parameters.contains(node.name)) continue;
            if (constants_.contains(node.name) || !named_constant(node.name)) node.name = prefix_ + node.name;
        }
    }

    void rename(std::vector<ModuleTemplate>& string, const Parameters& parameters) const {
        for (ModuleTemplate& module : string) {
            rename(module.symbol);
            for (Expression& argument : module.arguments) rename(argument, parameters);
        }
    }

    void rename(Production& production) const {
        Parameters parameters(production.parameters.begin(), production.parameters.end());
        for (auto* context : {&production.left_context, &production.right_context}) {
            for (ContextModule& module : *context) {
                rename(module.symbol);
                parameters.insert(module.parameters.begin(), module.parameters.end());
            }
        }
        rename(production.symbol);
        if (production.condition) rename(*production.condition, parameters);
        if (production.weight) rename(*production.weight, parameters);
        rename(production.successor, parameters);
    }
};

Expression::Node number_node(double value) { return {Op::number, value, {}, 0}; }

/// 0 -> 0, n -> n + by for n from 1: ((n - 1) % wide + (by + 1)) % (wide + by). The first remainder takes n = 0 to wide - 1,
/// which the second one takes to 0.
Expression raised(const Expression& number, int by) {
    if (number.postfix.size() == 1 && number.postfix.front().op == Op::number) {
        const double value = number.postfix.front().number;
        return number_expression(value == 0 ? 0 : value + by);
    }
    constexpr double wide = 1099511627776;  // 2^40: a power of two keeps the remainders exact
    Expression result = number;
    const auto apply = [&](Op op, double value) {
        result.postfix.push_back(number_node(value));
        result.postfix.push_back({op, 0, {}, 0});
    };
    apply(Op::subtract, 1);
    apply(Op::modulo, wide);
    apply(Op::add, by + 1.0);
    apply(Op::modulo, wide + by);
    return result;
}

void raise_styles(std::vector<ModuleTemplate>& string, int by) {
    for (ModuleTemplate& module : string) {
        if (module.symbol != ";") continue;
        for (Expression& argument : module.arguments) argument = raised(argument, by);
    }
}

}  // namespace

Grammar with_prefix(Grammar grammar, const std::string& prefix) {
    if (!prefix.empty()) Prefixer(grammar, prefix).rename(grammar);
    return grammar;
}

Grammar with_styles_raised(Grammar grammar, int by) {
    if (by == 0) return grammar;
    raise_styles(grammar.axiom, by);
    for (Production& production : grammar.productions) raise_styles(production.successor, by);
    for (Exception& exception : grammar.exceptions) raise_styles(exception.successor, by);
    for (NumberedStyle& style : grammar.styles) style.number += by;
    for (Terminal& terminal : grammar.terminals) {
        if (terminal.style != 0) terminal.style += by;
    }
    return grammar;
}

}  // namespace rinceau
