#include "lsystem/rule_loop.h"

#include <algorithm>
#include <cmath>

namespace rinceau {

namespace {

using Op = Expression::Op;

/// c in "name - c" (below 0) or "name + c" (above 0).
std::optional<double> change_of(const Expression& argument, const std::string& name) {
    const auto& nodes = argument.postfix;
    if (nodes.size() != 3 || nodes[0].op != Op::name || nodes[0].name != name || nodes[1].op != Op::number) return {};
    if (nodes[2].op == Op::add) return nodes[1].number;
    if (nodes[2].op == Op::subtract) return -nodes[1].number;
    return {};
}

struct Limit {
    Op comparison = Op::greater;
    double value = 0;
    ExpressionPlace place;
};

/// "name > limit" and the like, somewhere in the condition, with a limit that is one node.
std::optional<Limit> limit_of(const Expression& condition, const std::string& name, int production, const Scope& constants) {
    const auto& nodes = condition.postfix;
    for (std::size_t i = 0; i + 2 < nodes.size(); ++i) {
        if (nodes[i].op != Op::name || nodes[i].name != name) continue;
        const Op comparison = nodes[i + 2].op;
        if (comparison < Op::less || comparison > Op::not_equal || comparison == Op::equal) continue;
        const auto value = value_of({{nodes[i + 1]}}, constants);
        if (!value) continue;
        const int at = static_cast<int>(i) + 1;
        return Limit{comparison, *value, {ExpressionPlace::In::condition, production, {}, 0, 0, at, at + 1}};
    }
    return {};
}

/// `step` is what the parameter loses (gains, if it counts up) each time.
std::optional<CountLaw> law_of(Op comparison, bool up, double limit, double step) {
    const double start = up ? 0 : limit;
    const bool beyond = comparison == (up ? Op::less : Op::greater) || comparison == Op::not_equal;
    const bool reaching = comparison == (up ? Op::less_equal : Op::greater_equal);
    if (beyond) return CountLaw{step, start};
    if (reaching) return CountLaw{step, start - step};
    return {};
}

class LoopFinder {
  public:
    explicit LoopFinder(const Grammar& grammar) : grammar_(grammar), constants_(constants_of(grammar)) {}

    std::optional<RuleLoop> find(int index) const {
        const Production& production = grammar_.productions[static_cast<std::size_t>(index)];
        if (!production.condition) return {};
        std::vector<Approach> continuations;
        for (Approach& approach : approaches_of(production.successor, production.symbol))
            if (approach.own && approach.symbol >= 0) continuations.push_back(std::move(approach));
        if (continuations.empty()) return {};
        for (std::size_t parameter = 0; parameter < production.parameters.size(); ++parameter) {
            std::optional<RuleLoop> loop = counted_by(production, index, static_cast<int>(parameter), continuations);
            if (!loop) continue;
            loop->has_drawn_end = has_drawn_end(production);
            return loop;
        }
        return {};
    }

  private:
    const Grammar& grammar_;
    Scope constants_;

    std::optional<RuleLoop> counted_by(const Production& production, int index, int parameter,
                                       const std::vector<Approach>& continuations) const {
        const std::string& name = production.parameters[static_cast<std::size_t>(parameter)];
        std::optional<double> change;
        for (const Approach& approach : continuations) {
            const ModuleTemplate& module = production.successor[static_cast<std::size_t>(approach.symbol)];
            if (module.arguments.size() != production.parameters.size()) return {};
            const auto here = change_of(module.arguments[static_cast<std::size_t>(parameter)], name);
            if (!here || *here == 0 || (change && *change != *here)) return {};
            change = here;
        }
        const StringPlace place{StringPlace::In::production, index};
        const auto limit = limit_of(*production.condition, name, index, constants_in(grammar_, constants_, place));
        if (!limit) return {};
        const bool up = *change > 0;
        const auto law = law_of(limit->comparison, up, limit->value, std::abs(*change));
        if (!law) return {};
        return RuleLoop{index, parameter, up, *law, std::abs(*change), limit->place, continuations, false};
    }

    bool has_drawn_end(const Production& production) const {
        const bool drawn = std::ranges::any_of(
            grammar_.terminals, [&](const Terminal& terminal) { return terminal.symbol == production.symbol; });
        return drawn || std::ranges::any_of(grammar_.productions, [&](const Production& other) {
                   return &other != &production && other.symbol == production.symbol && !other.successor.empty() &&
                          other.parameters.size() == production.parameters.size();
               });
    }
};

}  // namespace

Scope constants_in(const Grammar& grammar, const Scope& constants, const StringPlace& string) {
    if (string.in != StringPlace::In::production) return constants;
    Scope scope = constants;
    for (const std::string& name : grammar.productions[static_cast<std::size_t>(string.index)].parameters)
        scope.constants.erase(name);
    return scope;
}

std::vector<RuleLoop> rule_loops(const Grammar& grammar) {
    const LoopFinder finder(grammar);
    std::vector<RuleLoop> loops;
    for (std::size_t i = 0; i < grammar.productions.size(); ++i)
        if (auto loop = finder.find(static_cast<int>(i))) loops.push_back(std::move(*loop));
    return loops;
}

std::vector<LoopUse> uses_of(const Grammar& grammar, const RuleLoop& loop) {
    const Production& production = grammar.productions[static_cast<std::size_t>(loop.production)];
    const Scope constants = constants_of(grammar);
    std::vector<LoopUse> uses;
    for (const StringPlace& place : strings_of(grammar)) {
        const bool inside = place.in == StringPlace::In::production &&
                            grammar.productions[static_cast<std::size_t>(place.index)].symbol == production.symbol;
        if (inside) continue;
        const auto& string = string_at(grammar, place);
        const Scope scope = constants_in(grammar, constants, place);
        for (std::size_t i = 0; i < string.size(); ++i) {
            if (string[i].symbol != production.symbol || string[i].arguments.size() != production.parameters.size())
                continue;
            const Expression& argument = string[i].arguments[static_cast<std::size_t>(loop.parameter)];
            LoopUse use{place, static_cast<int>(i), {}, {}, loop.law};
            std::optional<double> written = value_of(argument, scope);
            use.written = {ExpressionPlace::In::module,
                           0,
                           place,
                           static_cast<int>(i),
                           loop.parameter,
                           0,
                           static_cast<int>(argument.postfix.size())};
            if (loop.up && written) {
                use.law.offset += *written;
                use.written = loop.limit;
                written = value_of(part_at(grammar, loop.limit), constants);
            }
            if (written) use.count = std::max(0.0, std::ceil((*written - use.law.offset) / use.law.slope));
            uses.push_back(use);
        }
    }
    return uses;
}

}  // namespace rinceau
