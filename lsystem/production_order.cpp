#include "lsystem/production_order.h"

#include <algorithm>

namespace rinceau {

namespace {

/// The value of an expression that is constant and without mistakes.
std::optional<double> constant_value(const Expression& expression, const Scope& scope, const SourcePlace& place) {
    try {
        const Program program = compile_expression(expression, scope, place);
        if (is_constant(program)) return program.code.front().number;
    } catch (const InputError&) {
        // named where expressions are checked
    }
    return std::nullopt;
}

ProductionFacts facts_of(const Production& production, const Scope& scope) {
    ProductionFacts facts;
    if (production.weight) facts.weight = constant_value(*production.weight, scope, production.place);
    const bool everywhere = production.left_context.empty() && production.right_context.empty();
    if (!production.condition) {
        facts.always = everywhere;
    } else if (const std::optional<double> holds = constant_value(*production.condition, scope, production.place)) {
        facts.always = everywhere && *holds != 0;
        facts.never = *holds == 0;
    }
    return facts;
}

}  // namespace

std::vector<std::string> names_in(const Production& production, const std::vector<std::string>& others) {
    std::vector<std::string> names = production.parameters;
    for (const auto* context : {&production.left_context, &production.right_context}) {
        for (const ContextModule& module : *context)
            names.insert(names.end(), module.parameters.begin(), module.parameters.end());
    }
    names.insert(names.end(), others.begin(), others.end());
    return names;
}

ProductionKey key_of(const Production& production) {
    return {production.kind, production.symbol, production.parameters.size()};
}

ProductionOrder::ProductionOrder(const Grammar& grammar, const Scope& constants) {
    Scope scope = constants;
    for (const Production& production : grammar.productions) {
        scope.parameters = names_in(production, constants.parameters);
        alike[key_of(production)].push_back(facts.size());
        facts.push_back(facts_of(production, scope));
    }
}

std::vector<std::size_t> ProductionOrder::that_may_apply(const Grammar& grammar, const ProductionKey& key) const {
    const auto found = alike.find(key);
    if (found == alike.end()) return {};
    std::vector<std::size_t> result;
    bool passed = false;    // a production that always applies
    bool weighted = false;  // one with weight is among those before it, or is it
    for (const std::size_t index : found->second) {
        const bool has_weight = grammar.productions[index].weight.has_value();
        if (facts[index].never || (passed && !(weighted && has_weight))) continue;
        result.push_back(index);
        if (!passed) weighted = weighted || has_weight;
        passed = passed || facts[index].always;
    }
    return result;
}

bool ProductionOrder::applies_surely(const ProductionKey& key) const {
    const auto found = alike.find(key);
    return found != alike.end() &&
           std::ranges::any_of(found->second, [&](std::size_t index) { return facts[index].always; });
}

}  // namespace rinceau
