#include "lsystem/edit_styles.h"

#include <algorithm>

#include "lsystem/expression_place.h"
#include "lsystem/grammar_names.h"
#include "lsystem/style_text.h"

namespace rinceau {
namespace {

const Terminal& terminal_of(const Grammar& grammar, const std::string& symbol) {
    const auto found = std::ranges::find(grammar.terminals, symbol, &Terminal::symbol);
    if (found == grammar.terminals.end())
        throw InputError({}, "expected a terminal of the grammar, found " + symbol +
                                 ": what comes from a file that it uses is painted in that file");
    if (!found->verbatim.empty())
        throw InputError(found->place, "expected a terminal with outlines, found " + symbol +
                                           ", a fragment of SVG that holds its own colours");
    return *found;
}

/// Does a string choose the style, or may it?
bool is_chosen(const Grammar& grammar, int number) {
    for (const StringPlace& place : strings_of(grammar)) {
        for (const ModuleTemplate& module : string_at(grammar, place)) {
            if (module.symbol != ";") continue;
            const double* literal = literal_argument(module);
            if (literal == nullptr || *literal == number) return true;
        }
    }
    return false;
}

int free_number(const Grammar& grammar) {
    int number = 1;
    for (const NumberedStyle& style : grammar.styles) number = std::max(number, style.number + 1);
    return number;
}

}  // namespace

std::vector<std::string> sharing_style(const Grammar& grammar, const std::string& symbol) {
    const auto found = std::ranges::find(grammar.terminals, symbol, &Terminal::symbol);
    std::vector<std::string> symbols;
    if (found == grammar.terminals.end() || !found->verbatim.empty()) return symbols;
    for (const Terminal& terminal : grammar.terminals)
        if (terminal.style == found->style && terminal.verbatim.empty()) symbols.push_back(terminal.symbol);
    return symbols;
}

EditResult restyle_terminal(const Grammar& grammar, const std::string& symbol, const Style& style, RestyleWhat what) {
    const int old = terminal_of(grammar, symbol).style;
    EditResult result{grammar, {}};
    const auto known = std::ranges::find(result.grammar.styles, old, &NumberedStyle::number);
    if (known != result.grammar.styles.end() && style_text(known->style) == style_text(style)) return result;
    if (known == result.grammar.styles.end() && style_text(Style{}) == style_text(style)) return result;
    const std::vector<std::string> sharing = sharing_style(grammar, symbol);
    const bool all = what == RestyleWhat::all_that_share;
    const bool in_place = known != result.grammar.styles.end() && (all || (sharing.size() == 1 && !is_chosen(grammar, old)));
    if (in_place) {
        known->style = style;
        result.changes.push_back("style " + std::to_string(old) + " of " + symbol +
                                 (sharing.size() > 1 ? " and " + std::to_string(sharing.size() - 1) + " more" : "") +
                                 " changed");
        return result;
    }
    const int number = free_number(grammar);
    result.grammar.styles.push_back({.number = number, .style = style});
    for (Terminal& terminal : result.grammar.terminals) {
        const bool meant = all ? std::ranges::count(sharing, terminal.symbol) > 0 : terminal.symbol == symbol;
        if (meant) terminal.style = number;
    }
    result.changes.push_back(symbol + (all && sharing.size() > 1 ? " and all that share its style get" : " gets") +
                             " style " + std::to_string(number));
    return result;
}

}  // namespace rinceau
