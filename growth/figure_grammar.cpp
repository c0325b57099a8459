// What is placed, as placements and as a grammar.

#include <algorithm>
#include <map>
#include <set>

#include "growth/figures.h"
#include "lsystem/fit_box.h"
#include "lsystem/grammar_names.h"

namespace rinceau {
namespace {

Repaint combined(const Repaint& own, const Repaint& wanted) {
    return {wanted.fill ? wanted.fill : own.fill, wanted.stroke ? wanted.stroke : own.stroke};
}

void append_color(ModuleTemplates& string, const char* command, const std::optional<Color>& color) {
    if (!color) return;
    string.push_back({command, {}, {}});
    for (const std::uint8_t channel : {color->red, color->green, color->blue})
        string.back().arguments.push_back(number_expression(channel));
}

void append(ModuleTemplates& string, ModuleTemplates more) {
    string.insert(string.end(), std::make_move_iterator(more.begin()), std::make_move_iterator(more.end()));
}

/// "[f(3) -(90) f(2) +(90) ;(2) A]"
void append_part(ModuleTemplates& string, const Grammar& grammar, const Placement& part, double size) {
    string.push_back({"[", {}, {}});
    append(string, turtle_modules(part.pose, size, exact_digits));
    if (part.style != 0) string.push_back({";", {number_expression(part.style)}, {}});
    append_color(string, "fill", part.repaint.fill);
    append_color(string, "stroke", part.repaint.stroke);
    string.push_back({grammar.terminals[static_cast<std::size_t>(part.terminal)].symbol, {}, {}});
    string.push_back({"]", {}, {}});
}

/// Written in place: its parts, or the symbol of the production that draws them.
class PlacedFigureWriter {
  public:
    PlacedFigureWriter(const FiguredDrawing& drawing, const Box& canvas, Grammar& grammar)
        : drawing_(drawing), size_(std::max(diagonal(canvas), 1e-300)), grammar_(grammar) {}

    void write(const PlacedFigure& placed) {
        const Figure& figure = drawing_.figures[static_cast<std::size_t>(placed.figure)];
        if (figure.parts.size() == 1) {
            Placement part = figure.parts.front();
            part.pose = placed.pose * part.pose;
            part.repaint = combined(part.repaint, placed.repaint);
            append_part(grammar_.axiom, drawing_.grammar, part, size_);
            return;
        }
        grammar_.axiom.push_back({"[", {}, {}});
        append(grammar_.axiom, turtle_modules(placed.pose, size_, exact_digits));
        append_color(grammar_.axiom, "fill", placed.repaint.fill);
        append_color(grammar_.axiom, "stroke", placed.repaint.stroke);
        grammar_.axiom.push_back({production_of(placed, figure), {}, {}});
        grammar_.axiom.push_back({"]", {}, {}});
    }

  private:
    /// Parts in colours of their own lose them where the whole is repainted: that is a production of its own.
    std::string production_of(const PlacedFigure& placed, const Figure& figure) {
        const bool fill = placed.repaint.fill.has_value();
        const bool stroke = placed.repaint.stroke.has_value();
        const auto key = std::tuple{placed.figure, fill, stroke};
        if (const auto known = names_.find(key); known != names_.end()) return known->second;
        std::string name;
        for (const char c : figure.symbol) name += c == '+' || c == '.' ? '_' : c;
        if (name.size() > longest_name) name = "Figure" + std::to_string(placed.figure + 1);
        name = free_name(name, [&](const std::string& wanted) {
            return std::ranges::count(drawing_.grammar.terminals, wanted, &Terminal::symbol) > 0 ||
                   std::ranges::count(grammar_.productions, wanted, &Production::symbol) > 0;
        });
        Production production{.symbol = name};
        for (Placement part : figure.parts) {
            if (fill) part.repaint.fill.reset();
            if (stroke) part.repaint.stroke.reset();
            append_part(production.successor, drawing_.grammar, part, std::max(figure.radius, 1e-300));
        }
        grammar_.productions.push_back(std::move(production));
        return names_[key] = name;
    }

    static constexpr std::size_t longest_name = 24;
    const FiguredDrawing& drawing_;
    double size_;
    Grammar& grammar_;
    std::map<std::tuple<int, bool, bool>, std::string> names_;
};

/// What the figures do not use is left out; numbers of styles stay.
void keep_used(Grammar& grammar) {
    const UsedNames used = used_names(grammar);
    std::erase_if(grammar.terminals, [&](const Terminal& t) { return !used.symbols.contains(t.symbol); });
    std::set<int> styles = used.styles;
    for (const Terminal& terminal : grammar.terminals) styles.insert(terminal.style);
    std::erase_if(grammar.styles, [&](const NumberedStyle& style) { return !styles.contains(style.number); });
}

}  // namespace

std::vector<Placement> placements_of(const FiguredDrawing& drawing, const std::vector<PlacedFigure>& placed) {
    std::vector<Placement> placements;
    for (const PlacedFigure& figure : placed)
        for (Placement part : drawing.figures[static_cast<std::size_t>(figure.figure)].parts) {
            part.pose = figure.pose * part.pose;
            part.repaint = combined(part.repaint, figure.repaint);
            part.layer = 0;
            part.order = static_cast<int>(placements.size());
            placements.push_back(std::move(part));
        }
    return placements;
}

Grammar grammar_of(const FiguredDrawing& drawing, const std::vector<PlacedFigure>& placed, const Box& canvas) {
    Grammar grammar;
    grammar.title = drawing.grammar.title;
    grammar.canvas = canvas;
    grammar.styles = drawing.grammar.styles;
    grammar.terminals = drawing.grammar.terminals;
    PlacedFigureWriter writer(drawing, canvas, grammar);
    for (const PlacedFigure& figure : placed) writer.write(figure);
    keep_used(grammar);
    return grammar;
}

}  // namespace rinceau
