#include "lsystem/measure_symbol.h"

#include <algorithm>

#include "lsystem/to_scene.h"

namespace rinceau {

namespace {

std::string unused_symbol(const Grammar& grammar, const std::string& wanted) {
    const std::vector<std::string> symbols = symbols_of(grammar);
    return free_name(wanted, [&](const std::string& name) { return std::ranges::count(symbols, name) > 0; });
}

Box visible_box(const Element& element) {
    if (!element.verbatim.empty()) return element.verbatim_box;
    const Box outline = bounds(element.paths);
    return paints_stroke(element.style) ? grown(outline, 0.5 * element.style.stroke.width) : outline;
}

/// The grammar in which no symbol of `stopped` is rewritten. Productions keep their places.
Grammar stopped_grammar(const Grammar& grammar, const std::set<std::string>& stopped) {
    Grammar result = grammar;
    for (Production& production : result.productions) {
        if (stopped.contains(production.symbol)) production.condition = number_expression(0);
    }
    return result;
}

/// Of the exception at this address, or at the one above it.
int exception_at(const Grammar& grammar, std::vector<int> address) {
    for (int levels = 0; levels < 2 && !address.empty(); ++levels) {
        const auto found = std::ranges::find(grammar.exceptions, address, &Exception::address);
        if (found != grammar.exceptions.end()) return static_cast<int>(found - grammar.exceptions.begin());
        address.pop_back();
    }
    return -1;
}

WrittenString string_of(const Grammar& grammar, const Placement& placement) {
    const int production = placement.trail.back().production;
    if (production >= 0) return {WrittenString::Kind::production, production};
    constexpr int axiom = -1;
    if (production == axiom) return {WrittenString::Kind::axiom, 0};
    return {WrittenString::Kind::exception, exception_at(grammar, placement.address)};
}

std::vector<std::vector<double>> arguments_in_order(const Grammar& stopped, const std::string& symbol,
                                                    const DeriveOptions& options) {
    const ModuleString string = derive(stopped, options);
    std::vector<std::vector<double>> arguments;
    for (const Module& module : string.modules) {
        if (string.symbols[static_cast<std::size_t>(module.symbol)] == symbol) arguments.push_back(module.arguments);
    }
    return arguments;
}

}  // namespace

Box visible_box(const std::vector<Element>& elements) {
    Box box;
    for (const Element& element : elements) box = including(box, visible_box(element));
    return box;
}

Measure measure(const Grammar& grammar, const ModuleTemplates& string, const DeriveOptions& options) {
    Grammar alone = grammar;
    const std::string end = unused_symbol(grammar, "End");
    alone.axiom = string;
    alone.axiom.push_back({end, {}, {}});
    alone.exceptions.clear();
    alone.terminals.push_back({.symbol = end});

    std::vector<Placement> placements = interpret(alone, {.derive = options});
    const int end_terminal = static_cast<int>(alone.terminals.size()) - 1;
    const auto last = std::ranges::find(placements, end_terminal, &Placement::terminal);
    Measure result;
    if (last != placements.end()) {
        result.move = last->pose;
        result.colouring = {last->style, last->repaint};
        result.layer = last->layer;
        placements.erase(last);
    }
    result.outlines = static_cast<int>(placements.size());
    result.box = visible_box(to_scene(alone, placements).elements);
    return result;
}

std::vector<SymbolInstance> find_instances(const Grammar& grammar, const std::string& symbol, const std::set<std::string>& stopped,
                                     const DeriveOptions& options) {
    Grammar still = stopped_grammar(grammar, stopped);
    std::erase_if(still.terminals, [&](const Terminal& terminal) { return terminal.symbol == symbol; });
    still.terminals.push_back({.symbol = symbol});
    const int terminal = static_cast<int>(still.terminals.size()) - 1;

    std::vector<SymbolInstance> instances;
    const auto visit = [&](const Placement& placement) {
        if (placement.terminal != terminal) return;
        SymbolInstance instance{.string = string_of(grammar, placement), .position = placement.trail.back().position};
        instance.address = placement.address;
        instance.colouring = {placement.style, placement.repaint};
        instances.push_back(std::move(instance));
    };
    visit_placements(still, {.derive = options, .addresses = true, .trails = true}, visit);

    std::vector<std::vector<double>> arguments = arguments_in_order(still, symbol, options);
    for (std::size_t i = 0; i < instances.size(); ++i) {
        instances[i].measured = arguments.size() == instances.size();
        if (instances[i].measured) instances[i].arguments = std::move(arguments[i]);
    }
    return instances;
}

}  // namespace rinceau
