#include "exports/measured_modules.h"

#include <algorithm>

#include "lsystem/interpret.h"

namespace rinceau {

namespace {

bool is_symbol(const Grammar& grammar, const std::string& name) {
    const auto is_name = [&](const ModuleTemplate& module) { return module.symbol == name; };
    if (std::ranges::any_of(grammar.axiom, is_name)) return true;
    if (std::ranges::find(grammar.terminals, name, &Terminal::symbol) != grammar.terminals.end()) return true;
    return std::ranges::any_of(grammar.productions, [&](const Production& production) {
        return production.symbol == name || std::ranges::any_of(production.successor, is_name);
    });
}

/// A number that no style of the grammar has.
int unused_style(const Grammar& grammar) {
    int number = 1;
    for (const NumberedStyle& style : grammar.styles) number = std::max(number, style.number + 1);
    return number;
}

std::string text_of(const ModuleTemplate& module) {
    std::string text = module.symbol;
    for (const Expression& argument : module.arguments) text += ',' + to_text(argument);
    return text;
}

}  // namespace

MeasuredModules::MeasuredModules(const Grammar& grammar, const DeriveOptions& options)
    : options_(options), scratch_(grammar), probe_("Probe") {
    while (is_symbol(grammar, probe_)) probe_ += '_';
    for (Terminal& terminal : scratch_.terminals) {
        terminal.paths.clear();
        terminal.verbatim.clear();
    }
    scratch_.terminals.push_back({.symbol = probe_});
    scratch_.styles.push_back({.number = unused_style(grammar)});
}

const MeasuredModules::Measures& MeasuredModules::measured(const ModuleTemplate& module) {
    const auto [place, added] = known_.try_emplace(text_of(module));
    if (!added) return place->second;
    // under a style that nothing in the grammar sets: if it is still in force behind the module, the module sets none
    const int marker = scratch_.styles.back().number;
    scratch_.axiom = {{";", {number_expression(marker)}, {}}, module, {probe_, {}, {}}};
    Measures& measures = place->second;
    Placement last;
    visit_placements(scratch_, {.derive = options_}, [&](const Placement& placement) {
        ++measures.placements;
        last = placement;
    });
    --measures.placements;
    measures.move = Move{last.pose, last.layer, last.style == marker ? std::nullopt : std::optional(last.style)};
    return measures;
}

}  // namespace rinceau
