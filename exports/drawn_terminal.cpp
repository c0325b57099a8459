#include "exports/drawn_terminal.h"

#include <algorithm>

#include "exports/cut_holes.h"
#include "exports/plain_color.h"
#include "lsystem/turtle_commands.h"

namespace rinceau {

namespace {

double deviation_of(const Terminal& terminal) {
    constexpr double of_a_point = 1;  // any length: nothing is flattened
    const double size = outline_size(terminal);
    return flatness_share * (size > 0 ? size : of_a_point);
}

bool is_visible(const Paint& paint) { return !std::holds_alternative<NoPaint>(paint); }

bool is_translucent(const Style& style) {
    return style.opacity < 1 || (is_visible(style.fill) && style.fill_opacity < 1) ||
           (is_visible(style.stroke.paint) && style.stroke.opacity < 1);
}

bool uses(const Grammar& grammar, std::string_view command) {
    const auto has = [&](const std::vector<ModuleTemplate>& modules) {
        return std::ranges::find(modules, command, &ModuleTemplate::symbol) != modules.end();
    };
    return has(grammar.axiom) ||
           std::ranges::any_of(grammar.productions, [&](const Production& production) { return has(production.successor); });
}

}  // namespace

double outline_size(const Terminal& terminal) {
    const Box box = bounds(terminal.paths);
    return is_empty(box) ? 0 : abs(box.high - box.low);
}

DrawnTerminal drawn_terminal(const Terminal& terminal, const Style& style) {
    DrawnTerminal drawn;
    if (!terminal.verbatim.empty()) return drawn;
    if (const std::optional<PlainColor> fill = plain_color(style.fill)) {
        drawn.polygons = polygons_with_cut_holes(terminal.paths, style.fill_rule, deviation_of(terminal));
        if (!drawn.polygons.empty()) drawn.fill = fill->color;
    }
    if (const std::optional<PlainColor> line = plain_color(style.stroke.paint); line && style.stroke.width > 0) {
        drawn.line = line->color;
        drawn.width = style.stroke.width;
        drawn.fixed_width = style.stroke.fixed;
        drawn.outlines = terminal.paths;
        drawn.line_first = style.stroke_first;
    }
    return drawn;
}

Polygon polyline_of(const Path& path, double deviation) {
    Polygon corners = flattened(path, deviation);
    if (path.closed && !corners.empty() && corners.back() != corners.front()) corners.push_back(Point(corners.front()));
    return corners;
}

void expect_outlines(const Grammar& grammar, const std::string& format) {
    const auto is_fragment = [](const Terminal& terminal) { return !terminal.verbatim.empty(); };
    if (grammar.terminals.empty() || !std::ranges::all_of(grammar.terminals, is_fragment)) return;
    throw InputError(grammar.terminals.front().place,
                     "expected a terminal with a path, found only fragments of SVG, of which " + format +
                         " draws nothing; --to svg keeps them");
}

std::vector<std::string> drawing_notes(const Grammar& grammar, const std::string& format) {
    const auto any_style = [&](auto holds) {
        return std::ranges::any_of(grammar.styles, [&](const NumberedStyle& style) { return holds(style.style); });
    };
    std::vector<std::string> notes;
    const auto note = [&](bool needed, const std::string& text) {
        if (needed) notes.push_back(format + ' ' + text);
    };
    note(any_style([](const Style& s) { return is_gradient(s.fill) || is_gradient(s.stroke.paint); }),
         "has no gradients: they are their mean colours.");
    note(any_style(is_translucent), "is given opaque colours: opacities are left out.");
    note(any_style([](const Style& s) { return paints_stroke(s) && !s.stroke.dashes.empty(); }),
         "has no dashes: dashed lines are whole.");
    note(any_style([](const Style& s) { return paints_stroke(s) && s.stroke.pen != Linear2{}; }),
         "has round pens only: stretched strokes have their width before stretching.");
    note(uses(grammar, "z"), "paints in order of derivation: layers, z(k), are left out.");
    note(std::ranges::any_of(grammar.terminals, [](const Terminal& terminal) { return !terminal.verbatim.empty(); }),
         "cannot hold fragments of SVG: terminals made of them are left out.");
    return notes;
}

}  // namespace rinceau
