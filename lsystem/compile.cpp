#include "lsystem/compile.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "lsystem/expression_functions.h"

namespace rinceau {

namespace {

/// What a salt is for, so that draws of different kinds in one place differ.
enum class SaltOf : unsigned char { constant, command, symbol, condition, weight, choice, exception };

template <class... Steps>
std::uint64_t salt_of(SaltOf what, Steps... steps) {
    std::uint64_t salt = key_below(0, static_cast<std::uint64_t>(what));
    ((salt = key_below(salt, static_cast<std::uint64_t>(steps))), ...);
    return salt;
}

/// By name, so that a constant's draws do not depend on the others.
std::uint64_t salt_of_constant(const std::string& name) {
    std::uint64_t salt = salt_of(SaltOf::constant);
    for (const char letter : name) salt = key_below(salt, static_cast<unsigned char>(letter));
    return salt;
}

/// The values of the constants.
std::unordered_map<std::string, double> evaluate_constants(const Grammar& grammar, DrawKey root) {
    Scope scope;
    std::vector<double> stack;
    for (const Constant& constant : grammar.constants) {
        Program program = compile_expression(constant.value, scope, constant.place);
        salt_draws(program, salt_of_constant(constant.name));
        stack.resize(static_cast<std::size_t>(program.stack_size));
        const double value = evaluate(program, nullptr, stack.data(), root);
        if (!std::isfinite(value)) {
            throw InputError(constant.place, "expected a finite value of the constant " + constant.name + ", found " +
                                                 to_text(constant.value));
        }
        scope.constants.try_emplace(constant.name, value);
    }
    return scope.constants;
}

bool has_context(const Production& production) {
    return !production.left_context.empty() || !production.right_context.empty();
}

std::string line_text(const SourcePlace& place) {
    return place.line > 0 ? " in line " + std::to_string(place.line) : std::string();
}

void expect_derivable(const Grammar& grammar) {
    const auto refuse = [](const SourcePlace& place, const std::string& what) {
        throw InputError(place, "expected a grammar without " + what + ", which cannot be derived");
    };
    if (!grammar.uses.empty()) refuse(grammar.uses.front().place, "'use'");
    const auto in_context = std::ranges::find_if(grammar.productions, has_context);
    if (in_context != grammar.productions.end() && !grammar.exceptions.empty()) {
        throw InputError(grammar.exceptions.front().place,
                         "expected a grammar without exceptions, because the production of " + in_context->symbol +
                             line_text(in_context->place) +
                             " has a context, found 'except': give the symbol in that place a name of its own instead");
    }
}

class Compiler {
  public:
    Compiler(const Grammar& grammar, std::uint64_t seed)
        : result_{.grammar = &grammar,
                  .styles = StyleTable(grammar),
                  .exception_tree = ExceptionTree(grammar.exceptions),
                  .root = root_key(seed)} {}

    CompiledGrammar compile() {
        const Grammar& grammar = *result_.grammar;
        expect_derivable(grammar);
        scope_.constants = evaluate_constants(grammar, result_.root);
        add_symbols(grammar);
        for (const Production& production : grammar.productions) add_production(production);
        scope_.parameters.clear();
        result_.axiom = compile_string(grammar.axiom);
        for (const Exception& exception : grammar.exceptions) {
            result_.exceptions.push_back(compile_string(exception.successor, SaltOf::exception));
        }
        for (const std::string& symbol : grammar.ignored) number_of(symbol);
        result_.ignored.resize(result_.symbols.size());
        for (const std::string& symbol : grammar.ignored)
            result_.ignored[static_cast<std::size_t>(number_of(symbol))] = true;
        result_.terminal_of.resize(result_.symbols.size(), -1);
        result_.productions_of.resize(result_.symbols.size());
        for (const CompiledProduction& production : result_.productions) check_production_arity(production.successor);
        check_production_arity(result_.axiom);
        for (const CompiledString& successor : result_.exceptions) check_production_arity(successor);
        if (result_.contextual) check_contexts();
        return std::move(result_);
    }

  private:
    CompiledGrammar result_;
    Scope scope_;
    std::unordered_map<std::string, Symbol> numbers_;

    Symbol number_of(const std::string& symbol) {
        const auto [place, added] = numbers_.try_emplace(symbol, static_cast<Symbol>(result_.symbols.size()));
        if (added) result_.symbols.push_back(symbol);
        return place->second;
    }

    void add_symbols(const Grammar& grammar) {
        for (const TurtleCommandInfo& command : turtle_commands()) number_of(std::string(command.symbol));
        for (const Production& production : grammar.productions) {
            const auto symbol = static_cast<std::size_t>(number_of(production.symbol));
            if (symbol < command_count) {
                throw InputError(production.place,
                                 "expected a symbol of your own before ->, found the command '" + production.symbol + "'");
            }
            if (result_.productions_of.size() <= symbol) result_.productions_of.resize(symbol + 1);
            const auto index = static_cast<int>(&production - grammar.productions.data());
            result_.productions_of[symbol].of(production.kind).push_back(index);
        }
        for (const Terminal& terminal : grammar.terminals) {
            const auto symbol = static_cast<std::size_t>(number_of(terminal.symbol));
            if (result_.terminal_of.size() <= symbol) result_.terminal_of.resize(symbol + 1, -1);
            result_.terminal_of[symbol] = static_cast<int>(&terminal - grammar.terminals.data());
            if (terminal.verbatim.empty() && !result_.styles.contains(terminal.style)) {
                throw InputError(terminal.place, "expected 'style " + std::to_string(terminal.style) +
                                                     ": ..' in the grammar, for the terminal " + terminal.symbol);
            }
        }
    }

    Program compile_expression_here(const Expression& expression, const SourcePlace& place, std::uint64_t salt) {
        Program program = compile_expression(expression, scope_, place);
        salt_draws(program, salt);
        result_.random = result_.random || !program.draws.empty();
        result_.stack_size = std::max(result_.stack_size, program.stack_size);
        return program;
    }

    void add_production(const Production& production) {
        CompiledProduction compiled;
        compiled.symbol = number_of(production.symbol);
        compiled.kind = production.kind;
        compiled.parameters = static_cast<int>(production.parameters.size());
        scope_.parameters = production.parameters;
        compiled.left_context = compile_context(production.left_context);
        compiled.right_context = compile_context(production.right_context);
        compiled.context_parameters = static_cast<int>(scope_.parameters.size()) - compiled.parameters;
        result_.contextual = result_.contextual || has_context(production);
        const int turn = turn_of(compiled.symbol, production);
        compiled.conditional = production.condition.has_value();
        if (compiled.conditional) {
            compiled.condition = compile_expression_here(*production.condition, production.place,
                                                         salt_of(SaltOf::condition, compiled.kind, turn));
        }
        compiled.weighted = production.weight.has_value();
        if (compiled.weighted) {
            compiled.weight =
                compile_expression_here(*production.weight, production.place, salt_of(SaltOf::weight, compiled.kind, turn));
            compiled.salt = salt_of(SaltOf::choice, compiled.kind, turn);
            result_.random = true;
        }
        compiled.successor = compile_string(production.successor);
        result_.productions.push_back(std::move(compiled));
    }

    /// Its parameters come behind those that the scope has already.
    std::vector<CompiledContext> compile_context(const std::vector<ContextModule>& context) {
        std::vector<CompiledContext> result;
        for (const ContextModule& module : context) {
            if (find_turtle_command(module.symbol) != nullptr) {
                throw InputError(module.place,
                                 "expected a symbol of your own in a context, which looks past commands, "
                                 "found the command '" +
                                     module.symbol + "'");
            }
            scope_.parameters.insert(scope_.parameters.end(), module.parameters.begin(), module.parameters.end());
            result.push_back({number_of(module.symbol), static_cast<int>(module.parameters.size())});
        }
        return result;
    }

    /// Numbers of arguments that symbols stand with.
    std::map<Symbol, std::set<int>> standing_arities() const {
        std::map<Symbol, std::set<int>> arities;
        const auto look_at = [&](const CompiledString& string) {
            for (const CompiledModule& module : string) arities[module.symbol].insert(module.argument_count);
        };
        look_at(result_.axiom);
        for (const CompiledProduction& production : result_.productions) look_at(production.successor);
        return arities;
    }

    /// A symbol of a context must be able to stand there.
    void check_contexts() const {
        const std::map<Symbol, std::set<int>> arities = standing_arities();
        for (const Production& production : result_.grammar->productions) {
            for (const auto* context : {&production.left_context, &production.right_context}) {
                for (const ContextModule& module : *context) check_context(module, arities);
            }
        }
    }
    void check_context(const ContextModule& module, const std::map<Symbol, std::set<int>>& arities) const {
        const auto standing = arities.find(numbers_.at(module.symbol));
        const auto found = static_cast<int>(module.parameters.size());
        if (standing == arities.end() || standing->second.contains(found)) return;
        throw InputError(module.place, "expected " + std::to_string(*standing->second.begin()) +
                                           " parameter(s) of the context " + module.symbol +
                                           ", as where it stands in a string, found " + std::to_string(found));
    }

    /// The place of a production among those of its symbol and kind.
    int turn_of(Symbol symbol, const Production& production) {
        const std::vector<int>& alike = result_.productions_of[static_cast<std::size_t>(symbol)].of(production.kind);
        const auto index = static_cast<int>(&production - result_.grammar->productions.data());
        return static_cast<int>(std::ranges::find(alike, index) - alike.begin());
    }

    void check_arity(const ModuleTemplate& module) const {
        const TurtleCommandInfo* command = find_turtle_command(module.symbol);
        if (command != nullptr && !takes(*command, module.arguments.size())) {
            throw InputError(module.place, "expected " + arity_text(*command) + " argument(s) of the command " +
                                               module.symbol + ", found " + std::to_string(module.arguments.size()));
        }
    }

    static std::vector<int> all(ProductionsOfSymbol productions) {
        std::vector<int> result = std::move(productions.rewriting);
        result.insert(result.end(), productions.decomposition.begin(), productions.decomposition.end());
        result.insert(result.end(), productions.homomorphism.begin(), productions.homomorphism.end());
        return result;
    }

    /// A module of a symbol that has productions must fit one of them.
    void check_production_arity(const CompiledString& modules) const {
        for (const CompiledModule& module : modules) {
            const std::vector<int> candidates = all(result_.productions_of[static_cast<std::size_t>(module.symbol)]);
            const auto fits = [&](int index) {
                return result_.productions[static_cast<std::size_t>(index)].parameters == module.argument_count;
            };
            if (candidates.empty() || std::ranges::any_of(candidates, fits)) continue;
            const int wanted = result_.productions[static_cast<std::size_t>(candidates.front())].parameters;
            throw InputError(module.source->place, "expected " + std::to_string(wanted) + " argument(s) of " +
                                                       module.source->symbol + ", as in its production, found " +
                                                       std::to_string(module.argument_count));
        }
    }

    /// Where draws stand in a string: behind so many symbols, in so many commands of their kind that draw since the last
    /// one.
    struct DrawPlaces {
        int symbols = 0;
        std::array<int, command_count> commands{};
    };

    CompiledString compile_string(const std::vector<ModuleTemplate>& modules, SaltOf commands = SaltOf::command) {
        CompiledString result;
        DrawPlaces places;
        result.reserve(modules.size());
        for (const ModuleTemplate& module : modules) {
            check_arity(module);
            CompiledModule compiled;
            compiled.symbol = number_of(module.symbol);
            compiled.position = static_cast<int>(result.size());
            compiled.source = &module;
            compiled.argument_count = static_cast<int>(module.arguments.size());
            const bool is_command = compiled.symbol < command_count;
            if (!is_command) compiled.number = ++places.symbols;
            const auto symbol = static_cast<std::size_t>(compiled.symbol);
            const std::uint64_t salt = is_command ? salt_of(commands, symbol, places.symbols, places.commands[symbol])
                                                  : salt_of(SaltOf::symbol, commands, places.symbols);
            compile_arguments(compiled, salt);
            if (!is_command) {
                places.commands = {};
            } else if (draws(compiled)) {
                ++places.commands[symbol];
            }
            result.push_back(std::move(compiled));
        }
        return result;
    }

    static bool draws(const CompiledModule& module) {
        return std::ranges::any_of(module.arguments, [](const Program& argument) { return !argument.draws.empty(); });
    }

    void compile_arguments(CompiledModule& module, std::uint64_t salt) {
        module.first_value = result_.values.size();
        if (!add_numbers(module)) {
            result_.values.resize(module.first_value);
            for (const Expression& argument : module.source->arguments) {
                module.arguments.push_back(
                    compile_expression_here(argument, module.source->place, key_below(salt, module.arguments.size())));
            }
            fold_constants(module);
        }
        if (!module.constant) return;
        const auto first = result_.values.begin() + static_cast<std::ptrdiff_t>(module.first_value);
        if (!std::all_of(first, result_.values.end(), [](double value) { return std::isfinite(value); })) {
            throw InputError(module.source->place, "expected finite arguments of " + module.source->symbol);
        }
        if (module.symbol <= static_cast<Symbol>(TurtleCommand::right)) {
            const double angle = module.symbol == static_cast<Symbol>(TurtleCommand::right) ? -*first : *first;
            module.turn = {cosine_of_degrees(angle), sine_of_degrees(angle)};
        }
    }

    /// What is written as numbers needs no program; false if something else is among the arguments.
    bool add_numbers(const CompiledModule& module) {
        for (const Expression& argument : module.source->arguments) {
            if (argument.postfix.size() != 1 || argument.postfix.front().op != Expression::Op::number) return false;
            result_.values.push_back(argument.postfix.front().number);
        }
        return true;
    }

    void fold_constants(CompiledModule& module) {
        module.constant = std::ranges::all_of(module.arguments, is_constant);
        if (!module.constant) return;
        for (const Program& argument : module.arguments) result_.values.push_back(argument.code.front().number);
        module.arguments.clear();
    }
};

}  // namespace

void throw_not_finite(const CompiledModule& module) {
    throw InputError(module.source->place,
                     "expected finite arguments of " + module.source->symbol + ", found a division by zero or an overflow");
}

CompiledGrammar compile(const Grammar& grammar, std::optional<std::uint64_t> seed) {
    constexpr std::uint64_t default_seed = 1;
    return Compiler(grammar, seed.value_or(grammar.seed.value_or(default_seed))).compile();
}

}  // namespace rinceau
