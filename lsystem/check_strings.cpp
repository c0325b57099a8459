#include "lsystem/check_strings.h"

#include <algorithm>
#include <cmath>

#include "lsystem/number_text.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

KnownNames::KnownNames(const Grammar& grammar) : styles(grammar) {
    for (const Terminal& terminal : grammar.terminals) terminals.insert(terminal.symbol);
    for (const Production& production : grammar.productions) {
        std::vector<std::size_t>& known = arities[production.symbol];
        const std::size_t arity = production.parameters.size();
        if (std::ranges::find(known, arity) == known.end()) known.push_back(arity);
    }
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

    void warn(const ModuleTemplate& module, const std::string& message) { warnings_.push_back({module.place, message}); }

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
        const auto arities = names_.arities.find(module.symbol);
        if (arities != names_.arities.end()) {
            const std::vector<std::size_t>& known = arities->second;
            const bool fits = std::ranges::find(known, module.arguments.size()) != known.end();
            if (!fits) warn_of_count(module, std::to_string(known.front()), ", as in its production");
        } else if (!names_.terminals.contains(module.symbol)) {
            warn(module, "expected a command, a production's symbol or a terminal, found the unknown symbol '" +
                             module.symbol + "': add a production '" + module.symbol + " -> ..' or 'terminal " +
                             module.symbol + ": ..'");
        }
    }

    void check_arguments(const ModuleTemplate& module) {
        for (const Expression& argument : module.arguments) {
            try {
                const Program program = compile_expression(argument, scope_, module.place);
                if (is_constant(program)) check_constant(module, program.code.front().number);
            } catch (const InputError& error) {
                warnings_.push_back(warning_of(error));
            }
        }
    }

    void check_constant(const ModuleTemplate& module, double value) {
        if (!std::isfinite(value)) {
            warn(module, "expected a finite argument of " + module.symbol + ", found a division by zero or an overflow");
        } else if (module.symbol == "*" && !(value > 0)) {
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
