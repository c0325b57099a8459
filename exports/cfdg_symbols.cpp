#include "exports/cfdg_symbols.h"

#include <algorithm>
#include <cmath>

#include "exports/number.h"
#include "lsystem/derivation_facts.h"
#include "lsystem/interpret.h"

namespace rinceau {

namespace {

constexpr double largest_natural = 1e9;

bool is_natural(const Expression::Node& node) {
    return node.op == Expression::Op::number && node.number >= 0 && node.number <= largest_natural &&
           node.number == std::floor(node.number);
}

bool chooses_style(const std::vector<ModuleTemplate>& string) {
    return std::ranges::find(string, ";", &ModuleTemplate::symbol) != string.end();
}

}  // namespace

CfdgSymbols::CfdgSymbols(const Grammar& grammar, const DeriveOptions& options, bool live_random)
    : names(cfdg_words()), grammar_(grammar), options_(options) {
    styled = chooses_style(grammar.axiom) || std::ranges::any_of(grammar.productions, [](const Production& production) {
                 return chooses_style(production.successor);
             });
    for (const Constant& constant : grammar.constants) constants[constant.name] = names.take(constant.name);
    if (styled) style_name = names.take("style");
    find_looks(live_random);
    name_shapes(live_random);
    find_naturals();
}

void CfdgSymbols::find_looks(bool live_random) {
    visit_placements(grammar_, {.derive = options_}, [&](const Placement& placement) {
        ++placements;
        looks[placement.terminal].insert(placement.style);
    });
    if (!live_random) return;
    for (std::size_t i = 0; i < grammar_.terminals.size(); ++i) {
        std::set<int>& styles = looks[static_cast<int>(i)];
        styles.insert(0);
        if (!styled) continue;
        for (const NumberedStyle& style : grammar_.styles) styles.insert(style.number);
    }
}

void CfdgSymbols::name_shapes(bool live_random) {
    std::set<std::string> parameter_names;
    for (const Production& production : grammar_.productions) {
        const auto [place, added] = scopes.try_emplace({production.symbol, production.parameters.size()});
        if (!added) continue;
        CfdgScope& scope = place->second;
        scope.names = constants;
        scope.parameters = production.parameters;
        std::set<std::string> own;
        for (const std::string& parameter : production.parameters) {
            std::string name = parameter;
            while (names.is_taken(name) || own.contains(name)) name += '_';
            own.insert(name);
            scope.names[parameter] = name;
        }
        parameter_names.merge(own);
        scope.natural.assign(scope.parameters.size(), !live_random);
        if (styled) scope.style = style_name;
    }
    for (const std::string& name : parameter_names) names.take(name);
    for (auto& [signature, scope] : scopes) scope.shape = names.take(signature.first);
}

CfdgScope CfdgSymbols::scope_of(const Production& production, const CfdgScope& shape) const {
    CfdgScope scope = shape;
    scope.names = constants;
    for (std::size_t i = 0; i < production.parameters.size(); ++i)
        scope.names[production.parameters[i]] = shape.names.at(shape.parameters[i]);
    scope.parameters = production.parameters;
    return scope;
}

void CfdgSymbols::find_naturals() {
    const DerivationFacts facts = derivation_facts(grammar_, options_);
    depth = facts.depth;
    const auto for_each_range = [&](const auto& visit) {
        for (auto& [signature, scope] : scopes) {
            const auto found = facts.arguments.find(signature);
            if (found == facts.arguments.end()) continue;
            for (std::size_t i = 0; i < scope.natural.size(); ++i) visit(scope, i, found->second[i]);
        }
    };
    for_each_range([](CfdgScope& scope, std::size_t i, const ArgumentRange& range) {
        if (!range.whole || range.lowest < 0 || range.highest > largest_natural) scope.natural[i] = false;
    });
    for (bool changed = true; changed;) {
        changed = restrict_naturals(grammar_.axiom, CfdgScope{.names = constants});
        for (const Production& production : grammar_.productions) {
            const CfdgScope scope = scope_of(production, scopes.at({production.symbol, production.parameters.size()}));
            changed = restrict_naturals(production.successor, scope) || changed;
        }
    }
    for_each_range([&](const CfdgScope& scope, std::size_t i, const ArgumentRange& range) {
        if (scope.natural[i]) most_natural = std::max(most_natural, range.highest);
    });
}

bool CfdgSymbols::restrict_naturals(const std::vector<ModuleTemplate>& string, const CfdgScope& scope) {
    bool changed = false;
    for (const ModuleTemplate& module : string) {
        const auto called = scopes.find(signature_of(module));
        if (called == scopes.end()) continue;
        for (std::size_t i = 0; i < module.arguments.size(); ++i) {
            if (!called->second.natural[i] || natural_text(module.arguments[i], scope)) continue;
            called->second.natural[i] = false;
            changed = true;
        }
    }
    return changed;
}

std::optional<std::string> CfdgSymbols::natural_text(const Expression& expression, const CfdgScope& scope) const {
    const auto& nodes = expression.postfix;
    if (nodes.size() == 1) return natural_atom(nodes.front(), scope);
    if (nodes.size() != 3) return std::nullopt;
    const auto left = natural_atom(nodes[0], scope);
    const auto right = natural_atom(nodes[1], scope);
    if (!left || !right) return std::nullopt;
    if (nodes[2].op == Expression::Op::add) return *left + " + " + *right;
    // never below 0 in the derivation, so the natural difference is the difference
    if (nodes[2].op == Expression::Op::subtract) return *left + " -- " + *right;
    return std::nullopt;
}

std::optional<std::string> CfdgSymbols::natural_atom(const Expression::Node& node, const CfdgScope& scope) const {
    if (is_natural(node)) return number_of(node.number);
    if (node.op != Expression::Op::name) return std::nullopt;
    const auto parameter = std::ranges::find(scope.parameters, node.name);
    if (parameter != scope.parameters.end()) {
        const bool natural = scope.natural[static_cast<std::size_t>(parameter - scope.parameters.begin())];
        return natural ? std::optional(scope.names.at(node.name)) : std::nullopt;
    }
    const auto constant = std::ranges::find(grammar_.constants, node.name, &Constant::name);
    const bool natural = constant != grammar_.constants.end() && constant->value.postfix.size() == 1 &&
                         is_natural(constant->value.postfix.front());
    return natural ? std::optional(constants.at(node.name)) : std::nullopt;
}

}  // namespace rinceau
