#include "lsystem/grammar_names.h"

#include <algorithm>

#include "lsystem/expression_functions.h"
#include "lsystem/number_text.h"
#include "lsystem/parse_statement.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

bool is_command(const std::string& symbol) { return find_turtle_command(symbol) != nullptr; }

class UseCollector {
  public:
    explicit UseCollector(const Grammar& grammar) {
        for (const Production& production : grammar.productions) productions_[production.symbol].push_back(&production);
        for (const Terminal& terminal : grammar.terminals) terminals_[terminal.symbol] = &terminal;
        for (const Constant& constant : grammar.constants) constants_[constant.name] = &constant;
    }

    void add(const ModuleTemplates& string) {
        add_string(string);
        while (!open_.empty()) {
            const std::string symbol = open_.back();
            open_.pop_back();
            expand(symbol);
        }
    }

    UsedNames take() { return std::move(used_); }

  private:
    std::map<std::string, std::vector<const Production*>> productions_;
    std::map<std::string, const Terminal*> terminals_;
    std::map<std::string, const Constant*> constants_;
    UsedNames used_;
    std::vector<std::string> open_;

    void add_string(const ModuleTemplates& string) {
        for (const ModuleTemplate& module : string) {
            for (const Expression& argument : module.arguments) add_expression(argument);
            if (module.symbol == ";") add_style(module);
            if (!is_command(module.symbol) && used_.symbols.insert(module.symbol).second) open_.push_back(module.symbol);
        }
    }

    void add_style(const ModuleTemplate& module) {
        if (const double* number = literal_argument(module)) {
            used_.styles.insert(static_cast<int>(*number));
        } else {
            used_.any_style = true;
        }
    }

    void expand(const std::string& symbol) {
        for (const Production* production : productions_[symbol]) {
            if (production->condition) add_expression(*production->condition);
            if (production->weight) add_expression(*production->weight);
            add_string(production->successor);
        }
        const auto terminal = terminals_.find(symbol);
        if (terminal != terminals_.end()) used_.styles.insert(terminal->second->style);
    }

    /// A parameter that hides a constant counts as a use of it: that keeps too much rather than too little.
    void add_expression(const Expression& expression) {
        for (const Expression::Node& node : expression.postfix) {
            if (node.op != Expression::Op::name) continue;
            const auto constant = constants_.find(node.name);
            if (constant == constants_.end() || !used_.constants.insert(node.name).second) continue;
            add_expression(constant->second->value);
        }
    }
};

bool is_random(const Expression& expression) {
    return std::ranges::any_of(expression.postfix, [](const Expression::Node& node) {
        return node.op == Expression::Op::call && (node.name == "uniform" || node.name == "normal");
    });
}

bool is_random(const ModuleTemplates& string) {
    return std::ranges::any_of(string, [](const ModuleTemplate& module) {
        return std::ranges::any_of(module.arguments, [](const Expression& argument) { return is_random(argument); });
    });
}

/// What is used, and what those use that have never been used: they are not the edit's to take apart.
UsedNames used_now(const Grammar& grammar, const UsedNames& before) {
    UseCollector collector(grammar);
    collector.add(grammar.axiom);
    for (const Exception& exception : grammar.exceptions) collector.add(exception.successor);
    for (const std::string& symbol : symbols_of(grammar)) {
        if (!before.symbols.contains(symbol)) collector.add({ModuleTemplate{symbol, {}, {}}});
    }
    return collector.take();
}

}  // namespace

const double* literal_argument(const ModuleTemplate& module) {
    if (module.arguments.size() != 1) return nullptr;
    const std::vector<Expression::Node>& postfix = module.arguments.front().postfix;
    return postfix.size() == 1 && postfix.front().op == Expression::Op::number ? &postfix.front().number : nullptr;
}

UsedNames used_names(const Grammar& grammar, const ModuleTemplates& from) {
    UseCollector collector(grammar);
    collector.add(from);
    return collector.take();
}

UsedNames used_names(const Grammar& grammar) {
    UseCollector collector(grammar);
    collector.add(grammar.axiom);
    for (const Exception& exception : grammar.exceptions) collector.add(exception.successor);
    return collector.take();
}

std::vector<std::string> symbols_of(const Grammar& grammar) {
    std::vector<std::string> symbols;
    std::set<std::string> known;
    const auto add = [&](const std::string& symbol) {
        if (!is_command(symbol) && known.insert(symbol).second) symbols.push_back(symbol);
    };
    const auto add_string = [&](const ModuleTemplates& string) {
        for (const ModuleTemplate& module : string) add(module.symbol);
    };
    for (const Production& production : grammar.productions) add(production.symbol);
    for (const Terminal& terminal : grammar.terminals) add(terminal.symbol);
    add_string(grammar.axiom);
    for (const Production& production : grammar.productions) {
        for (const ContextModule& module : production.left_context) add(module.symbol);
        for (const ContextModule& module : production.right_context) add(module.symbol);
        add_string(production.successor);
    }
    for (const Exception& exception : grammar.exceptions) add_string(exception.successor);
    for (const std::string& symbol : grammar.ignored) add(symbol);
    return symbols;
}

bool draws_random_numbers(const Grammar& grammar) {
    const auto in_production = [](const Production& production) {
        return production.weight || (production.condition && is_random(*production.condition)) ||
               is_random(production.successor);
    };
    return is_random(grammar.axiom) || std::ranges::any_of(grammar.productions, in_production) ||
           std::ranges::any_of(grammar.exceptions,
                               [](const Exception& exception) { return is_random(exception.successor); }) ||
           std::ranges::any_of(grammar.constants, [](const Constant& constant) { return is_random(constant.value); });
}

bool may_name_symbol(const std::string& name) {
    const ExpressionFunction* function = find_expression_function(name);
    return is_name(name) && !is_command(name) && std::ranges::count(statement_words(), std::string_view(name)) == 0 &&
           !named_constant(name).has_value() && (function == nullptr || function->only_with_queries);
}

std::string free_name(const std::string& wanted, const std::function<bool(const std::string&)>& taken) {
    const auto unusable = [&](const std::string& name) { return !may_name_symbol(name) || taken(name); };
    if (!unusable(wanted)) return wanted;
    // Row -> Row2, Row2 -> Row3; A_1 -> A_1_2
    std::size_t end = wanted.size();
    while (end > 1 && is_digit(wanted[end - 1])) --end;
    const bool numbered = end < wanted.size() && wanted[end - 1] != '_';
    const std::string stem = numbered ? wanted.substr(0, end) : wanted;
    const std::string separator = !numbered && is_digit(wanted.back()) ? "_" : "";
    for (int number = 2;; ++number) {
        std::string name = stem + separator + std::to_string(number);
        if (!unusable(name)) return name;
    }
}

WithoutLeftovers without_leftovers(Grammar grammar, const UsedNames& before) {
    const UsedNames after = used_now(grammar, before);
    std::set<std::string> removed_symbols;
    std::set<std::string> removed_constants;
    std::set<int> removed_styles;
    const auto symbol_left = [&](const auto& part) {
        const bool left = before.symbols.contains(part.symbol) && !after.symbols.contains(part.symbol);
        if (left) removed_symbols.insert(part.symbol);
        return left;
    };
    std::erase_if(grammar.productions, symbol_left);
    std::erase_if(grammar.terminals, symbol_left);
    std::erase_if(grammar.ignored, [&](const std::string& symbol) { return removed_symbols.contains(symbol); });
    std::erase_if(grammar.constants, [&](const Constant& constant) {
        const bool left = before.constants.contains(constant.name) && !after.constants.contains(constant.name);
        if (left) removed_constants.insert(constant.name);
        return left;
    });
    if (!after.any_style) {
        std::erase_if(grammar.styles, [&](const NumberedStyle& style) {
            const bool left = before.styles.contains(style.number) && !after.styles.contains(style.number);
            if (left) removed_styles.insert(style.number);
            return left;
        });
    }
    WithoutLeftovers result{std::move(grammar), {removed_symbols.begin(), removed_symbols.end()}};
    for (const std::string& name : removed_constants) result.removed.push_back("the constant " + name);
    for (const int number : removed_styles) result.removed.push_back("style " + std::to_string(number));
    return result;
}

}  // namespace rinceau
