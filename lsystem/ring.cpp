#include "lsystem/ring.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

#include "geometry/index.h"
#include "lsystem/noise_form.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

constexpr double full_circle = 360;
constexpr double closing_error = 0.1;  // degrees over the whole ring: 7 times 51.43 is meant to close
constexpr double exact_error = 1e-6;   // degrees, where rounding is no excuse

/// Does what stands for the symbol leave the turtle as it is?
class Stillness {
  public:
    explicit Stillness(const Grammar& grammar) : grammar_(grammar) {}

    bool leaves_heading(const std::string& symbol) {
        if (!asked_.insert(symbol).second) return true;  // being looked at
        for (const Production& production : grammar_.productions) {
            if (production.symbol == symbol && !string_leaves_heading(production)) return false;
        }
        return true;
    }

  private:
    const Grammar& grammar_;
    std::set<std::string> asked_;

    bool string_leaves_heading(const Production& production) {
        int depth = 0;
        double sum = 0;
        const Scope none;
        for (const ModuleTemplate& module : production.successor) {
            depth += (module.symbol == "[") - (module.symbol == "]");
            if (depth > 0 || module.symbol == "]") continue;
            if (module.symbol == "|") return false;
            if (const int sign = turn_sign(module); sign != 0) {
                const auto value = value_of(module.arguments.front(), none);
                if (!value) return false;
                sum += sign * *value;
            } else if (find_turtle_command(module.symbol) == nullptr && !leaves_heading(module.symbol)) {
                return false;
            }
        }
        return std::abs(sum) < exact_error;
    }
};

/// Parameters that keep their value from one element to the next, with the value that the use gives them.
Scope steady_scope(const Grammar& grammar, const RuleLoop& loop, const LoopUse& use) {
    const Production& production = grammar.productions[at(loop.production)];
    const Scope constants = constants_of(grammar);
    Scope scope = constants_in(grammar, constants, {StringPlace::In::production, loop.production});
    const ModuleTemplate& started = string_at(grammar, use.string)[at(use.position)];
    const Scope outside = constants_in(grammar, constants, use.string);
    for (std::size_t i = 0; i < production.parameters.size(); ++i) {
        const bool kept = std::ranges::all_of(loop.continuations, [&](const Approach& approach) {
            return production.successor[at(approach.symbol)].arguments[i] == name_expression(production.parameters[i]);
        });
        if (!kept) continue;
        if (const auto value = value_of(started.arguments[i], outside))
            scope.constants.try_emplace(production.parameters[i], *value);
    }
    return scope;
}

/// Nothing but the style and the layer differs between the elements.
bool is_even(const Production& production, const RuleLoop& loop) {
    const std::string& counter = production.parameters[at(loop.parameter)];
    const int own = loop.continuations.front().symbol;
    for (std::size_t i = 0; i < production.successor.size(); ++i) {
        const ModuleTemplate& module = production.successor[i];
        if (static_cast<int>(i) == own || module.symbol == ";" || module.symbol == "z") continue;
        for (const Expression& argument : module.arguments)
            for (const Expression::Node& node : argument.postfix)
                if (node.op == Expression::Op::name && node.name == counter) return false;
    }
    return true;
}

}  // namespace

std::optional<double> turn_of(const Grammar& grammar, const RuleLoop& loop, const LoopUse& use) {
    if (loop.continuations.size() != 1) return {};
    const auto& string = grammar.productions[at(loop.production)].successor;
    const Scope scope = steady_scope(grammar, loop, use);
    Stillness stillness(grammar);
    double sum = 0;
    for (const int position : way_to(string, loop.continuations.front().symbol)) {
        const ModuleTemplate& module = string[at(position)];
        if (module.symbol == "|") return {};
        if (const int sign = turn_sign(module); sign != 0) {
            const auto value = value_of(without_noise(module.arguments.front()), scope);
            if (!value) return {};
            sum += sign * *value;
        } else if (module.symbol == "*" && module.arguments.size() == 1) {
            const auto value = value_of(without_noise(module.arguments.front()), scope);
            if (!value || *value != 1) return {};
        } else if (find_turtle_command(module.symbol) == nullptr && !stillness.leaves_heading(module.symbol)) {
            return {};
        }
    }
    return sum;
}

double elements_of(const RuleLoop& loop, const LoopUse& use) { return *use.count + (loop.has_drawn_end ? 1 : 0); }

bool closes(double elements, double turn) {
    const double around = elements * std::abs(turn) / full_circle;
    const double allowed = around > 1.5 ? exact_error : closing_error;  // more than once around is rarely meant
    return elements >= 2 && around >= 0.5 && std::abs(around - std::round(around)) * full_circle < allowed;
}

std::vector<Ring> closed_rings(const Grammar& grammar) {
    std::vector<Ring> rings;
    for (const RuleLoop& loop : rule_loops(grammar)) {
        const bool even = is_even(grammar.productions[at(loop.production)], loop);
        for (const LoopUse& use : uses_of(grammar, loop)) {
            if (!use.count) continue;
            const auto turn = turn_of(grammar, loop, use);
            const double elements = elements_of(loop, use);
            if (!turn || !closes(elements, *turn)) continue;
            const double around = std::round(elements * std::abs(*turn) / full_circle);
            const bool whole = elements > 1e9 || std::gcd(static_cast<long>(around), static_cast<long>(elements)) == 1;
            if (around > 1 && (!even || !whole)) continue;
            rings.push_back({loop, use, elements, *turn, around});
        }
    }
    return rings;
}

}  // namespace rinceau
