#include "lsystem/check_strings.h"

#include <algorithm>
#include <cmath>

#include "lsystem/expression_functions.h"
#include "lsystem/number_text.h"
#include "lsystem/similar_name.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

bool is_known(const Scope& scope, const std::string& name) {
    return scope.constants.contains(name) || named_constant(name) ||
           std::ranges::find(scope.parameters, name) != scope.parameters.end();
}

std::vector<std::string_view> names_of(const Scope& scope) {
    std::vector<std::string_view> names(scope.parameters.begin(), scope.parameters.end());
    for (const auto& [name, value] : scope.constants) names.push_back(name);
    return names;
}

}  // namespace

KnownNames::KnownNames(const Grammar& grammar, std::set<std::string> spoilt_names, bool is_complete)
    : styles(grammar), spoilt(std::move(spoilt_names)), complete(is_complete) {
    for (const Terminal& terminal : grammar.terminals) terminals.insert(terminal.symbol);
    for (const Production& production : grammar.productions) {
        std::vector<std::size_t>& known = arities[production.symbol];
        const std::size_t arity = production.parameters.size();
        if (std::ranges::find(known, arity) == known.end()) known.push_back(arity);
        for (const ContextModule& module : production.left_context) watched.insert(module.symbol);
        for (const ContextModule& module : production.right_context) watched.insert(module.symbol);
    }
    const auto see = [&](const std::vector<ModuleTemplate>& string) {
        for (const ModuleTemplate& module : string) occurring[module.symbol].insert(module.arguments.size());
    };
    see(grammar.axiom);
    for (const Production& production : grammar.productions) {
        if (production.kind != ProductionKind::homomorphism) see(production.successor);
    }
    for (const Exception& exception : grammar.exceptions) see(exception.successor);
    symbols.assign(terminals.begin(), terminals.end());
    for (const auto& [symbol, known] : arities) symbols.push_back(symbol);
}

CheckedExpression check_expression(const KnownNames& names, const Expression& expression, const Scope& scope,
                                   const SourcePlace& place) {
    CheckedExpression checked;
    std::set<std::string_view> unknown;
    for (const Expression::Node& node : expression.postfix) {
        if (node.op != Expression::Op::name || is_known(scope, node.name) || !unknown.insert(node.name).second) continue;
        if (names.is_excused(node.name)) continue;
        add_mistake(checked.mistakes, place,
                    "expected a parameter or a constant, found the unknown name '" + node.name + "'" +
                        did_you_mean(node.name, names_of(scope)) + ": add 'define " + node.name + " = ..'");
    }
    if (!unknown.empty()) return checked;
    try {
        Program program = compile_expression(expression, scope, place);
        if (!is_constant(program) || std::isfinite(program.code.front().number)) {
            checked.program = std::move(program);
        } else {
            add_mistake(checked.mistakes, place,
                        "expected a finite value of " + to_text(expression) + ", found a division by zero or an overflow");
        }
    } catch (const InputError& error) {
        add_mistake(checked.mistakes, error);
    }
    return checked;
}

namespace {

class StringChecker {
  public:
    StringChecker(const KnownNames& names, const Scope& scope) : names_(names), scope_(scope) {}

    std::vector<Warning> check(const std::vector<ModuleTemplate>& string) {
        for (const ModuleTemplate& module : string) {
            check_symbol(module);
            check_arguments(module);
        }
        check_brackets(string);
        return std::move(warnings_);
    }

  private:
    const KnownNames& names_;
    const Scope& scope_;
    std::vector<Warning> warnings_;

    void warn(const ModuleTemplate& module, const std::string& message) { add_mistake(warnings_, module.place, message); }

    void warn_of_count(const ModuleTemplate& module, const std::string& count, const std::string& why) {
        warn(module, "expected " + count + " argument(s) of " + module.symbol + why + ", found " +
                         std::to_string(module.arguments.size()));
    }

    void check_symbol(const ModuleTemplate& module) {
        if (const TurtleCommandInfo* command = find_turtle_command(module.symbol)) {
            if (takes(*command, module.arguments.size())) return;
            warn_of_count(module, arity_text(*command), " (" + std::string(command->help) + ")");
            return;
        }
        if (names_.spoilt.contains(module.symbol)) return;
        const auto arities = names_.arities.find(module.symbol);
        if (arities != names_.arities.end()) {
            const std::vector<std::size_t>& known = arities->second;
            const bool fits = std::ranges::find(known, module.arguments.size()) != known.end();
            if (!fits) warn_of_count(module, std::to_string(known.front()), ", as in its production");
        } else if (names_.complete && !names_.terminals.contains(module.symbol) && !names_.watched.contains(module.symbol)) {
            warn(module, "expected a command, a production's symbol or a terminal, found the unknown symbol '" +
                             module.symbol + "'" + did_you_mean(module.symbol, names_.symbols) + ": add a production '" +
                             module.symbol + " -> ..' or 'terminal " + module.symbol + ": ..'");
        }
    }

    void check_arguments(const ModuleTemplate& module) {
        for (const Expression& argument : module.arguments) {
            const CheckedExpression checked = check_expression(names_, argument, scope_, module.place);
            for (const Warning& mistake : checked.mistakes) add_mistake(warnings_, mistake.place, mistake.message);
            if (checked.program && is_constant(*checked.program))
                check_constant(module, checked.program->code.front().number);
        }
    }

    void check_constant(const ModuleTemplate& module, double value) {
        if (module.symbol == "*" && !(value > 0)) {
            warn(module, "expected a scale above 0 in *(..), found " + number_text(value));
        } else if (module.symbol == "z" && value != std::floor(value)) {
            warn(module, "expected a whole number of layers in z(..), found " + number_text(value));
        } else if (module.symbol == ";" && !is_style(value)) {
            warn(module, "expected the number of a style of the grammar, or 0, in ;(..), found " + number_text(value) +
                             ": add 'style " + number_text(value) + ": ..'");
        }
    }
    bool is_style(double value) const {
        constexpr double largest = 1e9;  // fits an int
        return value == std::floor(value) && std::abs(value) <= largest && names_.styles.contains(static_cast<int>(value));
    }

    void check_brackets(const std::vector<ModuleTemplate>& string) {
        std::vector<const ModuleTemplate*> open;
        for (const ModuleTemplate& module : string) {
            if (module.symbol == "[") open.push_back(&module);
            if (module.symbol != "]") continue;
            if (open.empty()) {
                warn(module, "expected a '[' before this ']', found none: add it or take the ']' away");
            } else {
                open.pop_back();
            }
        }
        for (const ModuleTemplate* module : open) {
            warn(*module, "expected a ']' for this '[', found none: add it or take the '[' away");
        }
    }
};

}  // namespace

std::vector<Warning> check_string(const KnownNames& names, const std::vector<ModuleTemplate>& string, const Scope& scope) {
    return StringChecker(names, scope).check(string);
}

}  // namespace rinceau
