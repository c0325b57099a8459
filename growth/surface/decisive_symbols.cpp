#include "growth/surface/decisive_symbols.h"

#include <algorithm>

namespace rinceau {

namespace {

/// Things that a successor places: at most two are counted; a symbol that is not known as decisive counts as two.
int things_placed(const std::vector<CompiledShapeCommand>& commands, const std::vector<bool>& decisive) {
    int things = 0;
    for (const CompiledShapeCommand& command : commands) {
        switch (command.verb) {
            case ShapeVerb::place:
            case ShapeVerb::place_clear:
            case ShapeVerb::place_merged:
            case ShapeVerb::line_segment:
            case ShapeVerb::lock:
                things += 1;
                break;
            case ShapeVerb::symbol:
                things += decisive[static_cast<std::size_t>(command.symbol)] ? 1 : 2;
                break;
            case ShapeVerb::chart:
                for (const auto& group : command.groups) things += things_placed(group, decisive);
                break;
            default:
                break;
        }
        if (things > 1) return 2;
    }
    return things;
}

}  // namespace

std::vector<bool> decisive_symbols(const CompiledShapeGrammar& grammar) {
    std::vector<bool> decisive(grammar.symbols.size());
    for (bool grows = true; grows;) {
        grows = false;
        for (std::size_t symbol = 0; symbol < decisive.size(); ++symbol) {
            if (decisive[symbol] || grammar.symbols[symbol].rules.empty()) continue;
            decisive[symbol] = std::ranges::all_of(grammar.symbols[symbol].rules, [&](int index) {
                const CompiledShapeRule& rule = grammar.rules[static_cast<std::size_t>(index)];
                return rule.priority >= 0 && things_placed(rule.successor, decisive) == 1;
            });
            grows = grows || decisive[symbol];
        }
    }
    return decisive;
}

}  // namespace rinceau
