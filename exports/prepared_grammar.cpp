#include "exports/prepared_grammar.h"

#include <algorithm>

#include "exports/carried_state.h"
#include "exports/drawn_terminal.h"
#include "exports/expression_writer.h"
#include "lsystem/flat_grammar.h"
#include "lsystem/turtle_commands.h"
#include "lsystem/unfolded_exceptions.h"

namespace rinceau {

namespace {

bool draws_numbers(const Expression& expression) { return calls(expression, "uniform") || calls(expression, "normal"); }

bool draws_numbers(const std::vector<ModuleTemplate>& modules) {
    return std::ranges::any_of(modules, [](const ModuleTemplate& module) {
        return std::ranges::any_of(module.arguments, [](const Expression& argument) { return draws_numbers(argument); });
    });
}

bool repaints(const std::vector<ModuleTemplate>& modules) {
    return std::ranges::any_of(
        modules, [](const ModuleTemplate& module) { return module.symbol == "fill" || module.symbol == "stroke"; });
}

bool repaints(const Grammar& grammar) {
    return repaints(grammar.axiom) || std::ranges::any_of(grammar.productions, [](const Production& production) {
               return repaints(production.successor);
           });
}

/// Style numbers become arguments; nothing if they cannot.
std::optional<PreparedGrammar> without_style_commands(Grammar grammar) {
    if (!remembers(grammar, TurtleMemory::style)) return PreparedGrammar{std::move(grammar)};
    std::optional<Grammar> styled = carried(grammar, TurtleMemory::style);
    if (!styled) return std::nullopt;
    return PreparedGrammar{std::move(*styled), true};
}

}  // namespace

std::vector<StyleChoice> styles_of(const PreparedGrammar& prepared, const Terminal& terminal) {
    std::vector<StyleChoice> choices{{}};
    for (const NumberedStyle& style : prepared.grammar.styles) {
        if (style.number == terminal.style) choices.front().style = style.style;
        if (prepared.styled) choices.push_back({style.number, style.style});
    }
    return choices;
}

std::set<std::string> all_symbols(const Grammar& grammar) {
    std::set<std::string> symbols;
    const auto look = [&](const std::vector<ModuleTemplate>& modules) {
        for (const ModuleTemplate& module : modules) {
            if (find_turtle_command(module.symbol) == nullptr) symbols.insert(module.symbol);
        }
    };
    look(grammar.axiom);
    for (const Production& production : grammar.productions) {
        symbols.insert(production.symbol);
        for (const auto* context : {&production.left_context, &production.right_context}) {
            for (const ContextModule& module : *context) symbols.insert(module.symbol);
        }
        look(production.successor);
    }
    for (const Terminal& terminal : grammar.terminals) symbols.insert(terminal.symbol);
    return symbols;
}

std::set<std::size_t> arities_of(const Grammar& grammar, const std::string& symbol) {
    std::set<std::size_t> arities;
    const auto look = [&](const std::vector<ModuleTemplate>& modules) {
        for (const ModuleTemplate& module : modules) {
            if (module.symbol == symbol) arities.insert(module.arguments.size());
        }
    };
    look(grammar.axiom);
    for (const Production& production : grammar.productions) look(production.successor);
    return arities;
}

bool is_random(const Grammar& grammar) {
    return draws_numbers(grammar.axiom) || std::ranges::any_of(grammar.productions, [](const Production& production) {
               return production.weight || draws_numbers(production.successor) ||
                      (production.condition && draws_numbers(*production.condition));
           });
}

bool has_contexts(const Grammar& grammar) {
    return std::ranges::any_of(grammar.productions, [](const Production& production) {
        return !production.left_context.empty() || !production.right_context.empty();
    });
}

std::optional<PreparedGrammar> prepared_rules(const Grammar& grammar, const ExportOptions& options,
                                              const std::string& format) {
    if (is_random(grammar) || repaints(grammar)) return std::nullopt;
    if (has_contexts(grammar) && options.derive.depth >= 0) return std::nullopt;
    std::optional<PreparedGrammar> prepared = without_style_commands(unfolded_exceptions(grammar, options.derive));
    if (!prepared) return std::nullopt;
    prepared->notes = drawing_notes(grammar, format);
    if (!grammar.exceptions.empty()) {
        prepared->notes.insert(prepared->notes.begin(),
                               format + " has no exceptions: the rules are written out where one applies.");
    }
    return prepared;
}

PreparedGrammar prepared_placements(const Grammar& grammar, const ExportOptions& options, const std::string& format,
                                    const std::string& reason) {
    std::optional<PreparedGrammar> flat = without_style_commands(flat_grammar(grammar, options.derive));
    flat->notes = drawing_notes(flat->grammar, format);
    flat->notes.insert(flat->notes.begin(), "The rules are not kept, every element is placed by itself: " + reason + '.');
    return std::move(*flat);
}

int steps_to_the_end(const Grammar& grammar, const DeriveOptions& options) {
    const std::string whole = to_text(derive(grammar, options));
    const auto is_whole = [&](int depth) {
        DeriveOptions limited = options;
        limited.depth = depth;
        return to_text(derive(grammar, limited)) == whole;
    };
    int enough = 1;
    while (!is_whole(enough)) enough *= 2;
    int too_few = enough / 2;
    while (enough - too_few > 1) {
        const int middle = too_few + (enough - too_few) / 2;
        (is_whole(middle) ? enough : too_few) = middle;
    }
    return enough;
}

}  // namespace rinceau
