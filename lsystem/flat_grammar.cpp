#include "lsystem/flat_grammar.h"

#include <algorithm>
#include <utility>

#include "geometry/angle.h"
#include "lsystem/interpret.h"
#include "lsystem/turtle_step.h"

namespace rinceau {

namespace {

using Modules = std::vector<ModuleTemplate>;

void append_command(Modules& modules, const std::string& symbol) { modules.push_back({symbol, {}, {}}); }

void append_command(Modules& modules, const std::string& symbol, double argument) {
    modules.push_back({symbol, {number_expression(argument)}, {}});
}

void append_turn(Modules& modules, double angle) {
    if (angle != 0) append_command(modules, angle < 0 ? "-" : "+", degrees(std::abs(angle)));
}

void append_color(Modules& modules, const std::string& command, const std::optional<Color>& color) {
    if (!color) return;
    append_command(modules, command, color->red);
    for (const std::uint8_t channel : {color->green, color->blue}) {
        modules.back().arguments.push_back(number_expression(channel));
    }
}

void append_placement(Modules& modules, const Grammar& grammar, const Placement& placement) {
    const TurtleStep step = to_turtle_step(placement.pose);
    append_command(modules, "[");
    append_turn(modules, step.turn);
    if (step.advance != 0) append_command(modules, "f", step.advance);
    if (step.scale != 1) append_command(modules, "*", step.scale);
    append_turn(modules, step.spin);
    if (step.mirrored) append_command(modules, "|");
    if (placement.style != 0) append_command(modules, ";", placement.style);
    append_color(modules, "fill", placement.repaint.fill);
    append_color(modules, "stroke", placement.repaint.stroke);
    append_command(modules, grammar.terminals[static_cast<std::size_t>(placement.terminal)].symbol);
    append_command(modules, "]");
}

/// The number of the style; neighbours often share one, so that only the newest are compared.
int style_number(Grammar& grammar, const Style& style) {
    constexpr std::size_t most_compared = 32;
    auto& styles = grammar.styles;
    const std::size_t oldest = styles.size() - std::min(styles.size(), most_compared);
    for (std::size_t i = styles.size(); i > oldest; --i)
        if (same_style(styles[i - 1].style, style, 0)) return styles[i - 1].number;
    styles.push_back({.number = static_cast<int>(styles.size()) + 1, .style = style});
    return styles.back().number;
}

}  // namespace

Grammar flat_grammar(const Grammar& grammar, const DeriveOptions& options) {
    Grammar flat = grammar;
    flat.axiom.clear();
    for (const Placement& placement : interpret(grammar, {.derive = options}))
        append_placement(flat.axiom, grammar, placement);
    flat.constants.clear();
    flat.productions.clear();
    flat.exceptions.clear();
    flat.uses.clear();
    flat.seed.reset();
    flat.ignored.clear();
    return flat;
}

Grammar flat_grammar(const Scene& scene) {
    Grammar flat;
    flat.canvas = scene.viewport;
    flat.sized = scene.sized;
    for (const Element& element : scene.elements) {
        Terminal terminal{.symbol = "E" + std::to_string(flat.terminals.size() + 1),
                          .paths = element.paths,
                          .verbatim = element.verbatim,
                          .verbatim_box = element.verbatim_box,
                          .id = element.id};
        if (element.verbatim.empty()) terminal.style = style_number(flat, element.style);
        append_command(flat.axiom, terminal.symbol);
        flat.terminals.push_back(std::move(terminal));
    }
    return flat;
}

}  // namespace rinceau
