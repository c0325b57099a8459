#include "editor/model/growth_view.h"

#include <algorithm>

#include "editor/model/grown_pattern.h"

namespace rinceau {
namespace {

double distance_to_segment(Point p, Point a, Point b) {
    const Point along = b - a;
    const double length2 = dot(along, along);
    const double share = length2 > 0 ? std::clamp(dot(p - a, along) / length2, 0.0, 1.0) : 0;
    return abs(p - (a + share * along));
}

}  // namespace

bool growth_is_open(const EditorState& state) {
    return state.shell.shown.right && state.shell.right_tab == EditorPanel::growth;
}

bool shows_grown(const EditorState& state) { return state.growth.shown && state.growth.grown != nullptr; }

const std::shared_ptr<const DerivedPicture>& canvas_picture(const EditorState& state) {
    return shows_grown(state) ? state.growth.grown->picture : state.picture;
}

GrowthBrush brush_on_canvas(const EditorState& state) {
    const GrowthSettings& settings = state.growth.settings;
    const bool arranges = growth_is_open(state) && settings.tab == GrowthTab::arrangement;
    return arranges ? settings.brush : GrowthBrush::none;
}

SourceQuestion source_question(const EditorState& state) {
    const GrowthState& growth = state.growth;
    return {state.document.resolved, growth.settings.raised, growth.settings.group, growth.flips};
}

const GrowthSource* current_source(const EditorState& state) {
    const auto& source = state.growth.source;
    return source && source->question == source_question(state) ? source.get() : nullptr;
}

double spray_radius(const EditorState& state) {
    const GrowthSource* source = current_source(state);
    const auto& grown = state.growth.grown;
    if (grown && grown->arrangement) source = grown->source.get();
    return source != nullptr && source->exemplar ? state.growth.settings.arrangement.brush * source->exemplar->mean_edge : 0;
}

Box growth_canvas(const EditorState& state) {
    const GrowthSettings& settings = state.growth.settings;
    Box canvas = state.document.resolved->canvas;
    if (is_empty(canvas)) canvas = {{0, 0}, {1, 1}};
    return widened(canvas, settings.tab == GrowthTab::arrangement ? settings.arrangement.canvas : settings.aggregate.canvas);
}

bool shows_edges(const EditorState& state) {
    const bool arranges = state.growth.settings.tab == GrowthTab::arrangement;
    return state.growth.settings.edges && arranges && growth_is_open(state);
}

std::vector<std::array<Point, 2>> edges_of(const Exemplar& exemplar) {
    std::vector<std::array<Point, 2>> edges;
    const auto position = [&](int element) { return exemplar.elements[static_cast<std::size_t>(element)].position; };
    for (const auto& [a, b] : exemplar.edges)  // the lower one comes first: copies in other tiles come last
        if (static_cast<std::size_t>(a) < exemplar.originals) edges.push_back({position(a), position(b)});
    return edges;
}

std::optional<std::pair<int, int>> exemplar_edge_at(const Exemplar& exemplar, Point at, double reach) {
    std::optional<std::pair<int, int>> nearest;
    double best = reach;
    for (const auto& edge : exemplar.edges) {
        const double distance = distance_to_segment(at, exemplar.elements[static_cast<std::size_t>(edge.first)].position,
                                                    exemplar.elements[static_cast<std::size_t>(edge.second)].position);
        if (distance > best) continue;
        best = distance;
        nearest = edge;
    }
    return nearest;
}

std::vector<std::string> symbols_to_raise(const Grammar& grammar) {
    std::vector<std::string> symbols;
    for (const Production& production : grammar.productions)
        if (std::ranges::count(symbols, production.symbol) == 0) symbols.push_back(production.symbol);
    return symbols;
}

bool has_grown(const EditorState& state) {
    const auto& grown = state.growth.grown;
    return grown && !grown->placed.empty();
}

bool has_arrangement(const EditorState& state) { return state.growth.grown && state.growth.grown->arrangement; }

}  // namespace rinceau
