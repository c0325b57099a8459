#include "exports/prepared_grammar.h"

#include <algorithm>

#include "exports/carried_state.h"
#include "exports/colors_as_styles.h"
#include "exports/drawn_terminal.h"
#include "lsystem/flat_grammar.h"
#include "lsystem/grammar_names.h"
#include "lsystem/turtle_commands.h"
#include "lsystem/unfolded_exceptions.h"

namespace rinceau {

namespace {

/// Style numbers become arguments.
PreparedGrammar without_style_commands(Grammar grammar) {
    if (!remembers(grammar, TurtleMemory::style)) return {.grammar = std::move(grammar)};
    std::optional<Grammar> styled = carried(grammar, TurtleMemory::style);
    if (!styled) throw RulesLost{"a style is in force beyond the symbol that sets it"};
    return {.grammar = std::move(*styled), .styled = true};
}

PreparedGrammar prepared_rules(const Grammar& grammar, const ExportOptions& options, const std::string& format) {
    if (draws_random_numbers(grammar)) throw RulesLost{"what is drawn by chance is frozen as the seed makes it"};
    if (has_color_commands(grammar)) throw RulesLost{"they change colours"};
    if (has_contexts(grammar) && options.derive.depth >= 0) throw RulesLost{"they have contexts, and the depth is limited"};
    PreparedGrammar prepared = without_style_commands(unfolded_exceptions(grammar, options.derive));
    prepared.notes = drawing_notes(grammar, format);
    if (!grammar.exceptions.empty()) {
        prepared.notes.insert(prepared.notes.begin(),
                              format + " has no exceptions: the rules are written out where one applies.");
    }
    return prepared;
}

PreparedGrammar prepared_placements(const Grammar& grammar, const ExportOptions& options, const std::string& format,
                                    const std::string& reason) {
    PreparedGrammar flat = without_style_commands(colors_as_styles(flat_grammar(grammar, options.derive)));
    flat.notes = drawing_notes(flat.grammar, format);
    flat.notes.insert(flat.notes.begin(), "The rules are not kept, every element is placed by itself: " + reason + '.');
    return flat;
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

bool has_contexts(const Grammar& grammar) {
    return std::ranges::any_of(grammar.productions, [](const Production& production) {
        return !production.left_context.empty() || !production.right_context.empty();
    });
}

Export write_prepared(const Grammar& grammar, const ExportOptions& options, const std::string& format,
                      const std::function<Export(const PreparedGrammar&)>& write) {
    expect_outlines(grammar, format);
    // What is wrong with a rule is told by deriving, be it not at all.
    DeriveOptions axiom_only = options.derive;
    axiom_only.depth = 0;
    derive(grammar, axiom_only);
    try {
        return write(prepared_rules(grammar, options, format));
    } catch (const RulesLost& lost) {
        return write(prepared_placements(grammar, options, format, lost.reason));
    }
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
