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

/// The figure's parts in the scene, in the colours that they have there.
std::vector<Placement> parts_of(const Figure& figure, const PlacedFigure& placed) {
    std::vector<Placement> parts = figure.parts;
    for (std::size_t i = 0; i < parts.size(); ++i) {
        parts[i].pose = placed.pose * parts[i].pose;
        if (i < placed.repaints.size()) parts[i].repaint = combined(parts[i].repaint, placed.repaints[i]);
    }
    return parts;
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

    /// Parts in colours of their own stand in the axiom one by one: productions are for what is drawn alike again and again.
    void write(const PlacedFigure& placed) {
        const Figure& figure = drawing_.figures[static_cast<std::size_t>(placed.figure)];
        if (figure.parts.size() == 1 || !placed.repaints.empty()) {
            for (const Placement& part : parts_of(figure, placed))
                append_part(grammar_.axiom, drawing_.grammar, part, size_);
            return;
        }
        grammar_.axiom.push_back({"[", {}, {}});
        append(grammar_.axiom, turtle_modules(placed.pose, size_, exact_digits));
        grammar_.axiom.push_back({production_of(placed.figure), {}, {}});
        grammar_.axiom.push_back({"]", {}, {}});
    }

  private:
    std::string production_of(int index) {
        if (const auto known = names_.find(index); known != names_.end()) return known->second;
        const Figure& figure = drawing_.figures[static_cast<std::size_t>(index)];
        std::string name;
        for (const char c : figure.symbol) name += c == '+' || c == '.' ? '_' : c;
        if (name.size() > longest_name) name = "Figure" + std::to_string(index + 1);
        name = free_name(name, [&](const std::string& wanted) {
            return std::ranges::count(drawing_.grammar.terminals, wanted, &Terminal::symbol) > 0 ||
                   std::ranges::count(grammar_.productions, wanted, &Production::symbol) > 0;
        });
        Production production{.symbol = name};
        for (const Placement& part : figure.parts)
            append_part(production.successor, drawing_.grammar, part, std::max(figure.radius, 1e-300));
        grammar_.productions.push_back(std::move(production));
        return names_[index] = name;
    }

    static constexpr std::size_t longest_name = 24;
    const FiguredDrawing& drawing_;
    double size_;
    Grammar& grammar_;
    std::map<int, std::string> names_;
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
        for (Placement& part : parts_of(drawing.figures[static_cast<std::size_t>(figure.figure)], figure)) {
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
