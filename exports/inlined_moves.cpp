#include "exports/inlined_moves.h"

#include <algorithm>

#include "exports/call_graph.h"

namespace rinceau {

namespace {

using Strings = std::vector<ModuleTemplate>;
constexpr std::size_t most_modules = 20'000;

/// `expression` with arguments in the place of parameters. A constant that `hidden` names hide is written as its definition.
Expression substituted(const Expression& expression, const Production& production, const Strings::value_type& module,
                       const std::vector<std::string>& hidden, const Grammar& grammar) {
    Expression result;
    const auto append = [&](const Expression& part) {
        result.postfix.insert(result.postfix.end(), part.postfix.begin(), part.postfix.end());
    };
    for (const Expression::Node& node : expression.postfix) {
        if (node.op != Expression::Op::name) {
            result.postfix.push_back(node);
            continue;
        }
        const auto parameter = std::ranges::find(production.parameters, node.name);
        if (parameter != production.parameters.end()) {
            append(module.arguments[static_cast<std::size_t>(parameter - production.parameters.begin())]);
            continue;
        }
        const auto constant = std::ranges::find(grammar.constants, node.name, &Constant::name);
        const bool is_hidden = std::ranges::find(hidden, node.name) != hidden.end();
        if (is_hidden && constant != grammar.constants.end()) {
            append(substituted(constant->value, production, module, hidden, grammar));
        } else {
            result.postfix.push_back(node);
        }
    }
    return result;
}

/// One round over a string; false if nothing was replaced.
bool inline_once(Strings& string, const std::vector<std::string>& parameters, const CallGraph& calls,
                 const Grammar& grammar) {
    Strings result;
    bool replaced = false;
    for (std::size_t i = 0; i < string.size(); ++i) {
        const ModuleTemplate& module = string[i];
        const auto& productions = calls.productions_of(signature_of(module));
        const bool plain = productions.size() == 1 && !productions.front()->condition && !productions.front()->weight &&
                           !calls.recurs(signature_of(module));
        const bool by_numbers = calls.draws(module) && is_constant(module, parameters);
        if (!plain || calls.stays(module) || by_numbers || !calls.matters(string, i)) {
            result.push_back(module);
            continue;
        }
        replaced = true;
        for (ModuleTemplate part : productions.front()->successor) {
            for (Expression& argument : part.arguments)
                argument = substituted(argument, *productions.front(), module, parameters, grammar);
            result.push_back(std::move(part));
        }
    }
    string = std::move(result);
    return replaced;
}

}  // namespace

bool is_constant(const ModuleTemplate& module, const std::vector<std::string>& parameters) {
    return std::ranges::all_of(module.arguments, [&](const Expression& argument) {
        return std::ranges::all_of(argument.postfix, [&](const Expression::Node& node) {
            const bool random = node.op == Expression::Op::call && (node.name == "uniform" || node.name == "normal");
            const bool parameter =
                node.op == Expression::Op::name && std::ranges::find(parameters, node.name) != parameters.end();
            return !random && !parameter;
        });
    });
}

std::optional<Grammar> inlined_moves(const Grammar& grammar) {
    Grammar result = grammar;
    for (bool replaced = true; replaced;) {
        const Grammar before = result;
        const CallGraph calls(before);
        std::size_t modules = 0;
        replaced = inline_once(result.axiom, {}, calls, before);
        modules += result.axiom.size() > before.axiom.size() ? result.axiom.size() : 0;
        for (Production& production : result.productions) {
            replaced = inline_once(production.successor, production.parameters, calls, before) || replaced;
            modules += production.successor.size();
        }
        if (modules > most_modules) return std::nullopt;
    }
    return result;
}

}  // namespace rinceau
