#include "growth/surface/shape_grammar_hints.h"

#include <algorithm>
#include <set>
#include <string>
#include <tuple>

namespace rinceau {

namespace {

using Commands = std::vector<CompiledShapeCommand>;

template <class Visit>
void visit_all(const Commands& commands, const Visit& visit) {
    for (const CompiledShapeCommand& command : commands) {
        visit(command);
        for (const Commands& group : command.groups) visit_all(group, visit);
    }
}

/// A shape that is not placed, or a line that meets another, ends what follows.
bool may_end_what_follows(ShapeVerb verb) {
    return verb == ShapeVerb::place_clear || verb == ShapeVerb::place_merged || verb == ShapeVerb::lock ||
           verb == ShapeVerb::line_segment;
}

class HintFinder {
  public:
    HintFinder(const ShapeGrammar& grammar, const CompiledShapeGrammar& compiled) : grammar_(grammar), compiled_(compiled) {}

    std::vector<Warning> find() {
        find_reached();
        hint_unreached();
        hint_endless();
        hint_unused();
        std::ranges::stable_sort(hints_, {},
                                 [](const Warning& hint) { return std::tuple(hint.place.line, hint.place.column); });
        return std::move(hints_);
    }

  private:
    const ShapeGrammar& grammar_;
    const CompiledShapeGrammar& compiled_;
    std::set<int> reached_;  // symbols
    std::vector<Warning> hints_;

    const CompiledShapeRule& rule(int index) const { return compiled_.rules[static_cast<std::size_t>(index)]; }
    const ShapeSymbol& symbol(int index) const { return compiled_.symbols[static_cast<std::size_t>(index)]; }
    int symbols() const { return static_cast<int>(compiled_.symbols.size()); }

    void find_reached() {
        std::vector<int> waiting;
        const auto reach = [&](const CompiledShapeCommand& command) {
            if (command.verb == ShapeVerb::symbol && reached_.insert(command.symbol).second)
                waiting.push_back(command.symbol);
        };
        for (const CompiledShapeAxiom& axiom : compiled_.axioms) visit_all(axiom.commands, reach);
        while (!waiting.empty()) {
            const int next = waiting.back();
            waiting.pop_back();
            for (const int index : symbol(next).rules) visit_all(rule(index).successor, reach);
        }
    }

    void hint_unreached() {
        for (int i = 0; i < symbols(); ++i) {
            if (reached_.contains(i)) continue;
            hints_.push_back({rule(symbol(i).rules.front()).source->place,
                              "no axiom leads to the symbol '" + symbol(i).name + "': its rules are never applied"});
        }
    }

    /// The least set of symbols that can end: some rule has a condition or a probability, or can be ended by a collision
    /// before it goes on, or goes on with symbols that can end only.
    std::set<int> ending_symbols() const {
        const std::set<int> stopping = stopping_symbols();
        std::set<int> ending;
        const auto ends = [&](int index) {
            const CompiledShapeRule& candidate = rule(index);
            if (!candidate.condition.empty() || !candidate.probability.empty()) return true;
            bool result = true;
            bool stopped = false;
            visit_all(candidate.successor, [&](const CompiledShapeCommand& command) {
                stopped = stopped || may_end_what_follows(command.verb) ||
                          (command.verb == ShapeVerb::symbol && stopping.contains(command.symbol));
                result = result && (command.verb != ShapeVerb::symbol || ending.contains(command.symbol));
            });
            return result || stopped;
        };
        for (bool grew = true; grew;) {
            grew = false;
            for (int i = 0; i < symbols(); ++i)
                if (!ending.contains(i) && std::ranges::any_of(symbol(i).rules, ends)) grew = ending.insert(i).second;
        }
        return ending;
    }

    /// Symbols that a collision can end.
    std::set<int> stopping_symbols() const {
        std::set<int> stopping;
        for (bool grew = true; grew;) {
            grew = false;
            for (int i = 0; i < symbols(); ++i) {
                if (stopping.contains(i)) continue;
                bool stops = false;
                for (const int index : symbol(i).rules)
                    visit_all(rule(index).successor, [&](const CompiledShapeCommand& command) {
                        stops = stops || may_end_what_follows(command.verb) ||
                                (command.verb == ShapeVerb::symbol && stopping.contains(command.symbol));
                    });
                if (stops) grew = stopping.insert(i).second;
            }
        }
        return stopping;
    }

    void hint_endless() {
        const auto all = grammar_.options.find("collide");
        if (all != grammar_.options.end() && all->second.text == "all") return;  // every I may end what follows
        const std::set<int> ending = ending_symbols();
        for (const int i : reached_) {
            if (ending.contains(i)) continue;
            hints_.push_back({rule(symbol(i).rules.front()).source->place,
                              "the symbol '" + symbol(i).name +
                                  "' goes on for ever: no rule has a condition or a probability, and nothing is placed that "
                                  "could collide; only a limit ends it"});
        }
    }

    void hint_unused() {
        std::set<int> shapes;
        const auto look = [&](const CompiledShapeCommand& command) { shapes.insert(command.shape); };
        for (const CompiledShapeAxiom& axiom : compiled_.axioms) visit_all(axiom.commands, look);
        for (const CompiledShapeRule& rule : compiled_.rules) visit_all(rule.successor, look);
        for (std::size_t i = 0; i < grammar_.shapes.size(); ++i) {
            if (shapes.contains(static_cast<int>(i))) continue;
            hints_.push_back({grammar_.shapes[i].place, "the shape '" + grammar_.shapes[i].name + "' is never placed"});
        }
        const std::set<std::string> names = names_in_use();
        for (const ShapeParam& param : grammar_.params)
            if (!names.contains(param.name)) hints_.push_back({param.place, "the param '" + param.name + "' is never used"});
    }

    std::set<std::string> names_in_use() const {
        std::set<std::string> names;
        const auto add = [&](const Expression& expression) {
            for (const Expression::Node& node : expression.postfix)
                if (node.op == Expression::Op::name) names.insert(node.name);
        };
        const auto add_commands = [&](const CompiledShapeCommand& command) {
            for (const Expression& argument : command.source->arguments) add(argument);
        };
        for (const ShapeParam& param : grammar_.params) add(param.value);
        for (const auto* sources : {&grammar_.shapes, &grammar_.fields})
            for (const ShapeSource& source : *sources)
                for (const auto& [key, value] : source.numbers) add(value);
        for (const auto& [name, option] : grammar_.options)
            for (const auto& [key, value] : option.numbers) add(value);
        for (const CompiledShapeAxiom& axiom : compiled_.axioms) {
            for (const Expression& number : axiom.source->numbers) add(number);
            visit_all(axiom.commands, add_commands);
        }
        for (const CompiledShapeRule& rule : compiled_.rules) {
            if (rule.source->condition) add(*rule.source->condition);
            if (rule.source->probability) add(*rule.source->probability);
            visit_all(rule.successor, add_commands);
        }
        return names;
    }
};

}  // namespace

std::vector<Warning> shape_grammar_hints(const ShapeGrammar& grammar, const CompiledShapeGrammar& compiled) {
    return HintFinder(grammar, compiled).find();
}

}  // namespace rinceau
