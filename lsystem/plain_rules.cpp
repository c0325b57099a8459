#include "lsystem/plain_rules.h"

#include <algorithm>
#include <map>
#include <set>

#include "lsystem/expression_functions.h"

namespace rinceau {

namespace {

std::set<std::string> names_in_use(const Grammar& grammar) {
    std::set<std::string> names;
    for (const ModuleTemplate& module : grammar.axiom) names.insert(module.symbol);
    for (const Terminal& terminal : grammar.terminals) names.insert(terminal.symbol);
    for (const Production& production : grammar.productions) {
        names.insert(production.symbol);
        for (const ModuleTemplate& module : production.successor) names.insert(module.symbol);
    }
    return names;
}

/// Symbols that a homomorphism must not write as they are -> the names they have there.
std::map<std::string, std::string> second_names(const Grammar& grammar) {
    std::set<std::string> taken = names_in_use(grammar);
    std::set<std::string> rewritten;
    for (const Production& production : grammar.productions) {
        if (production.kind != ProductionKind::homomorphism) rewritten.insert(production.symbol);
    }
    std::map<std::string, std::string> names;
    for (const std::string& symbol : rewritten) {
        std::string name = symbol + "_drawn";
        while (!taken.insert(name).second) name += '_';
        names[symbol] = name;
    }
    return names;
}

void rename(std::vector<ModuleTemplate>& modules, const std::map<std::string, std::string>& names) {
    for (ModuleTemplate& module : modules) {
        const auto found = names.find(module.symbol);
        if (found != names.end()) module.symbol = found->second;
    }
}

int rank_of(const Production& production) {
    switch (production.kind) {
        case ProductionKind::decomposition:
            return 0;
        case ProductionKind::rewriting:
            return 1;
        case ProductionKind::homomorphism:
            return 2;
    }
    return 0;
}

bool is_random(const Expression& expression) {
    return std::ranges::any_of(expression.postfix, [](const Expression::Node& node) {
        if (node.op != Expression::Op::call) return false;
        const ExpressionFunction* function = find_expression_function(node.name);
        return function != nullptr && function->evaluate == nullptr;
    });
}

bool is_random(const std::vector<ModuleTemplate>& modules) {
    return std::ranges::any_of(modules, [](const ModuleTemplate& module) {
        return std::ranges::any_of(module.arguments, [](const Expression& argument) { return is_random(argument); });
    });
}

}  // namespace

Grammar plain_rules(const Grammar& grammar) {
    Grammar plain = grammar;
    std::ranges::stable_sort(plain.productions, {}, rank_of);
    const auto is_homomorphism = [](const Production& production) {
        return production.kind == ProductionKind::homomorphism;
    };
    if (std::ranges::none_of(plain.productions, is_homomorphism)) {
        for (Production& production : plain.productions) production.kind = ProductionKind::rewriting;
        return plain;
    }
    const std::map<std::string, std::string> names = second_names(grammar);
    std::vector<Production> renamed;
    for (Production& production : plain.productions) {
        const bool drawn = is_homomorphism(production);
        production.kind = ProductionKind::rewriting;
        if (!drawn) continue;
        rename(production.successor, names);
        const auto name = names.find(production.symbol);
        if (name == names.end()) continue;
        renamed.push_back(production);
        renamed.back().symbol = name->second;
    }
    plain.productions.insert(plain.productions.end(), renamed.begin(), renamed.end());
    for (const Terminal& terminal : grammar.terminals) {
        const auto name = names.find(terminal.symbol);
        if (name == names.end()) continue;
        plain.terminals.push_back(terminal);
        plain.terminals.back().symbol = name->second;
        plain.terminals.back().id.clear();
    }
    return plain;
}

bool is_stochastic(const Grammar& grammar) {
    const auto draws = [](const Production& production) {
        return production.weight || (production.condition && is_random(*production.condition)) ||
               is_random(production.successor);
    };
    return is_random(grammar.axiom) || std::ranges::any_of(grammar.productions, draws) ||
           std::ranges::any_of(grammar.constants, [](const Constant& constant) { return is_random(constant.value); }) ||
           std::ranges::any_of(grammar.exceptions,
                               [](const Exception& exception) { return is_random(exception.successor); });
}

bool is_context_sensitive(const Grammar& grammar) {
    return std::ranges::any_of(grammar.productions, [](const Production& production) {
        return !production.left_context.empty() || !production.right_context.empty();
    });
}

}  // namespace rinceau
