#include "lsystem/edit_inline.h"

#include <algorithm>
#include <optional>
#include <set>

#include "lsystem/expression_place.h"
#include "lsystem/grammar_names.h"
#include "lsystem/moved_exceptions.h"
#include "lsystem/noise_form.h"
#include "lsystem/plain_rules.h"

namespace rinceau {
namespace {

std::set<std::string> names_of(const Production& production) {
    std::set<std::string> names(production.parameters.begin(), production.parameters.end());
    for (const auto* context : {&production.left_context, &production.right_context})
        for (const ContextModule& module : *context) names.insert(module.parameters.begin(), module.parameters.end());
    return names;
}

/// The place of the one rule that may be put in the place of its symbol, or why there is none.
struct FoundRule {
    std::size_t index = 0;
    std::string why_not;
};

FoundRule find_rule(const Grammar& grammar, const std::string& symbol) {
    FoundRule found;
    std::size_t count = 0;
    for (std::size_t i = 0; i < grammar.productions.size(); ++i) {
        if (grammar.productions[i].symbol != symbol) continue;
        found.index = i;
        ++count;
    }
    if (count != 1) return {0, "which has " + std::to_string(count)};
    const Production& rule = grammar.productions[found.index];
    const bool plain = rule.kind == ProductionKind::rewriting && !rule.condition && !rule.weight &&
                       rule.left_context.empty() && rule.right_context.empty();
    if (!plain) found.why_not = "whose rule does not always apply";
    if (std::ranges::count(rule.successor, symbol, &ModuleTemplate::symbol) > 0) found.why_not = "whose rule holds itself";
    if (is_context_sensitive(grammar)) found.why_not = "in a grammar where neighbours count";
    return found;
}

Expression with_arguments(const Expression& expression, const Production& rule, const std::vector<Expression>& arguments) {
    Expression result;
    for (const Expression::Node& node : expression.postfix) {
        const auto parameter =
            node.op == Expression::Op::name ? std::ranges::find(rule.parameters, node.name) : rule.parameters.end();
        if (parameter == rule.parameters.end()) {
            result.postfix.push_back(node);
            continue;
        }
        const Expression& argument = arguments[static_cast<std::size_t>(parameter - rule.parameters.begin())];
        result.postfix.insert(result.postfix.end(), argument.postfix.begin(), argument.postfix.end());
    }
    return result;
}

/// A name in the rule that is a parameter where the symbol stands; empty = there is none.
std::string captured_name(const Production& rule, const std::set<std::string>& parameters) {
    for (const ModuleTemplate& module : rule.successor)
        for (const Expression& argument : module.arguments)
            for (const Expression::Node& node : argument.postfix)
                if (node.op == Expression::Op::name && parameters.contains(node.name) &&
                    std::ranges::count(rule.parameters, node.name) == 0)
                    return node.name;
    return {};
}

class Inliner {
  public:
    Inliner(const Grammar& grammar, const Production& rule) : grammar_(grammar), rule_(rule) {}

    ModuleTemplates inlined(const StringPlace& place) {
        ModuleTemplates result;
        for (const ModuleTemplate& module : string_at(grammar_, place)) {
            if (module.symbol != rule_.symbol) {
                result.push_back(module);
                continue;
            }
            expect_use(module, place);
            ++uses_;
            for (ModuleTemplate part : rule_.successor) {
                for (Expression& argument : part.arguments) argument = with_arguments(argument, rule_, module.arguments);
                part.place = {};
                result.push_back(std::move(part));
            }
        }
        return result;
    }
    int uses() const { return uses_; }

  private:
    const Grammar& grammar_;
    const Production& rule_;
    int uses_ = 0;

    void expect_use(const ModuleTemplate& module, const StringPlace& place) const {
        const auto refuse = [&](const std::string& expected) {
            throw InputError(module.place, "expected " + expected + " where " + rule_.symbol + " stands");
        };
        if (module.arguments.size() != rule_.parameters.size()) refuse("the arguments that its rule takes");
        if (std::ranges::any_of(module.arguments, is_random)) refuse("arguments that are not drawn at random");
        if (place.in != StringPlace::In::production) return;
        const Production& owner = grammar_.productions[static_cast<std::size_t>(place.index)];
        if (owner.kind == ProductionKind::homomorphism) refuse("no homomorphism");
        const std::string captured = captured_name(rule_, names_of(owner));
        if (!captured.empty()) refuse("no parameter " + captured + ", which its rule means otherwise,");
    }
};

}  // namespace

EditResult inline_rule(const Grammar& grammar, const std::string& symbol) {
    const FoundRule found = find_rule(grammar, symbol);
    if (!found.why_not.empty())
        throw InputError({},
                         "expected a symbol with one rule, which always applies, found " + symbol + ", " + found.why_not);
    Inliner inliner(grammar, grammar.productions[found.index]);
    EditResult result{grammar, {}};
    for (const StringPlace& place : strings_of(grammar)) string_at(result.grammar, place) = inliner.inlined(place);
    if (inliner.uses() == 0) throw InputError({}, "expected a symbol that stands somewhere, found " + symbol);
    result.grammar.productions.erase(result.grammar.productions.begin() + static_cast<std::ptrdiff_t>(found.index));
    const std::vector<Exception> moved = moved_exceptions(grammar, result.grammar, symbol);
    for (std::size_t i = 0; i < moved.size(); ++i) result.grammar.exceptions[i].address = moved[i].address;
    result.changes.push_back("the rule of " + symbol + " stands in " + std::to_string(inliner.uses()) +
                             (inliner.uses() == 1 ? " place" : " places") + " now");
    if (draws_random_numbers(grammar)) result.changes.push_back("what is drawn at random is drawn anew");
    return result;
}

std::vector<std::string> symbols_to_inline(const Grammar& grammar) {
    std::set<std::string> used;
    for (const StringPlace& place : strings_of(grammar))
        for (const ModuleTemplate& module : string_at(grammar, place)) used.insert(module.symbol);
    std::vector<std::string> symbols;
    for (const Production& production : grammar.productions)
        if (used.contains(production.symbol) && find_rule(grammar, production.symbol).why_not.empty())
            symbols.push_back(production.symbol);
    return symbols;
}

}  // namespace rinceau
