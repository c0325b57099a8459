#include "exports/carried_state.h"

#include <algorithm>
#include <set>
#include <vector>

#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

using Modules = std::vector<ModuleTemplate>;

std::string_view command_of(TurtleMemory memory) { return memory == TurtleMemory::style ? ";" : "*"; }

bool is_number(const Expression& expression, double value) {
    return expression.postfix.size() == 1 && expression.postfix.front().op == Expression::Op::number &&
           expression.postfix.front().number == value;
}

Expression product(const Expression& a, const Expression& b) {
    if (is_number(a, 1)) return b;
    if (is_number(b, 1)) return a;
    Expression result = a;
    result.postfix.insert(result.postfix.end(), b.postfix.begin(), b.postfix.end());
    result.postfix.push_back({Expression::Op::multiply, 0, {}, 0});
    return result;
}

bool is_symbol(const ModuleTemplate& module) { return find_turtle_command(module.symbol) == nullptr; }

/// Symbols whose expansion ends with another style or scale than it began with.
std::set<std::string> leaving_symbols(const Grammar& grammar, std::string_view command) {
    std::set<std::string> leaving;
    const auto leaves = [&](const Modules& modules) {
        int open = 0;
        for (const ModuleTemplate& module : modules) {
            open += module.symbol == "[" ? 1 : module.symbol == "]" ? -1 : 0;
            if (open <= 0 && (module.symbol == command || leaving.contains(module.symbol))) return true;
        }
        return false;
    };
    for (bool grown = true; grown;) {
        grown = false;
        for (const Production& production : grammar.productions) {
            if (!leaving.contains(production.symbol) && leaves(production.successor)) {
                leaving.insert(production.symbol);
                grown = true;
            }
        }
    }
    return leaving;
}

std::set<std::string> names_in(const Grammar& grammar) {
    std::set<std::string> names{"pi", "e"};
    for (const Constant& constant : grammar.constants) names.insert(constant.name);
    for (const Production& production : grammar.productions) {
        names.insert(production.parameters.begin(), production.parameters.end());
        for (const auto* context : {&production.left_context, &production.right_context}) {
            for (const ContextModule& module : *context) names.insert(module.parameters.begin(), module.parameters.end());
        }
    }
    return names;
}

std::string fresh_name(const std::string& wish, std::set<std::string>& names) {
    std::string name = wish;
    for (int k = 2; names.contains(name); ++k) name = wish + std::to_string(k);
    names.insert(name);
    return name;
}

class Carrier {
  public:
    Carrier(const Grammar& grammar, TurtleMemory memory)
        : memory_(memory), command_(command_of(memory)), leaving_(leaving_symbols(grammar, command_)) {}

    /// False if it cannot be done.
    bool carry(Modules& modules, const Expression& at_first) {
        std::vector<State> states{{at_first, true}};
        Modules result;
        for (ModuleTemplate& module : modules) {
            if (!pass(std::move(module), states, result)) return false;
        }
        modules = std::move(result);
        return states.size() == 1;
    }

  private:
    struct State {
        Expression value;
        bool known = true;  ///< false after a symbol that leaves something else behind
    };

    TurtleMemory memory_;
    std::string_view command_;
    std::set<std::string> leaving_;

    bool pass(ModuleTemplate module, std::vector<State>& states, Modules& result) const {
        State& state = states.back();
        if (module.symbol == command_) {
            if (memory_ == TurtleMemory::style) {
                state = {module.arguments.front(), true};
            } else {
                state.value = product(state.value, module.arguments.front());
            }
            return true;
        }
        if (module.symbol == "[") states.push_back(State(state));
        if (module.symbol == "]") {
            if (states.size() == 1) return false;
            states.pop_back();
        }
        const bool moves = memory_ == TurtleMemory::scale && module.symbol == "f";
        if (!moves && !is_symbol(module)) {
            result.push_back(std::move(module));
            return true;
        }
        if (!state.known) return false;
        if (moves) {
            module.arguments.front() = product(module.arguments.front(), state.value);
        } else {
            module.arguments.push_back(state.value);
            state.known = !leaving_.contains(module.symbol);
        }
        result.push_back(std::move(module));
        return true;
    }
};

}  // namespace

bool remembers(const Grammar& grammar, TurtleMemory memory) {
    const auto has = [&](const Modules& modules) {
        return std::ranges::find(modules, command_of(memory), &ModuleTemplate::symbol) != modules.end();
    };
    return has(grammar.axiom) ||
           std::ranges::any_of(grammar.productions, [&](const Production& production) { return has(production.successor); });
}

std::optional<Grammar> carried(const Grammar& grammar, TurtleMemory memory) {
    Grammar result = grammar;
    std::set<std::string> names = names_in(grammar);
    const std::string name = fresh_name(memory == TurtleMemory::style ? "style" : "s", names);
    Carrier carrier(grammar, memory);
    if (!carrier.carry(result.axiom, number_expression(memory == TurtleMemory::style ? 0 : 1))) return std::nullopt;
    for (Production& production : result.productions) {
        if (!carrier.carry(production.successor, name_expression(name))) return std::nullopt;
        production.parameters.push_back(name);
        for (auto* context : {&production.left_context, &production.right_context}) {
            for (ContextModule& module : *context) module.parameters.push_back(fresh_name(name, names));
        }
    }
    return result;
}

}  // namespace rinceau
