// Exemplars from drawings: figures are elements, sorted into kinds.

#include <algorithm>
#include <cmath>
#include <utility>

#include "growth/arrangement/exemplar.h"
#include "growth/arrangement/kinds.h"

namespace rinceau {
namespace {

/// What an instance paints, about its own place.
Region outline_about_place(const FiguredDrawing& drawing, const FigureInstance& instance) {
    Similarity about_place = instance.pose;
    about_place.translation = {};
    Region outline = drawing.figures[static_cast<std::size_t>(instance.figure)].outline;
    for (auto& polygon : outline)
        for (Point& corner : polygon) corner = apply(about_place, corner);
    return outline;
}

bool ends_at_edge(const Region& outline, Point place, const Box& canvas) {
    if (is_empty(canvas)) return false;
    constexpr double hair = 0.005;  // of the element
    Box box = bounds(outline);
    box = {box.low + place, box.high + place};
    return !contains(canvas, grown(box, hair * diagonal(box)));
}

/// Pieces go to the kind of whole elements that is nearest to them in size, and kinds that hold nothing else are dropped:
/// cut shapes look like nothing that could be met again.
void sort_pieces(std::vector<ExemplarPoint>& points, std::vector<std::string>& names) {
    std::vector<double> largest(names.size());  // radius of whole elements by kind, 0 = none
    std::vector<double> radii;
    for (const ExemplarPoint& point : points) {
        double radius = 0;
        for (const auto& polygon : point.outline)
            for (const Point corner : polygon) radius = std::max(radius, abs(corner));
        radii.push_back(radius);
        double& of_kind = largest[static_cast<std::size_t>(point.symbol)];
        if (point.whole) of_kind = std::max(of_kind, radius);
    }
    std::vector<int> kept(names.size(), -1);
    std::vector<std::string> kept_names;
    for (std::size_t kind = 0; kind < names.size(); ++kind) {
        if (!(largest[kind] > 0)) continue;
        kept[kind] = static_cast<int>(kept_names.size());
        kept_names.push_back(names[kind]);
    }
    if (kept_names.empty()) return;
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::size_t kind = static_cast<std::size_t>(points[i].symbol);
        const auto difference = [&](std::size_t other) { return std::abs(largest[other] - radii[i]); };
        if (kept[kind] < 0)
            for (std::size_t other = 0; other < names.size(); ++other)
                if (kept[other] >= 0 && (kept[kind] < 0 || difference(other) < difference(kind))) kind = other;
        points[i].symbol = kept[kind];
    }
    names = std::move(kept_names);
}

}  // namespace

Exemplar make_exemplar(const FiguredDrawing& drawing, const ExemplarOptions& options, const std::string& label) {
    ElementKinds kinds = element_kinds(drawing);
    std::vector<ExemplarPoint> points;
    std::vector<bool> at_edge;
    std::vector<bool> has_free_copy(drawing.figures.size());
    for (std::size_t i = 0; i < drawing.instances.size(); ++i) {
        const FigureInstance& instance = drawing.instances[i];
        ExemplarPoint point{.position = instance.pose.translation, .symbol = kinds.of_instance[i], .whole = instance.whole};
        point.outline = outline_about_place(drawing, instance);
        at_edge.push_back(ends_at_edge(point.outline, point.position, drawing.grammar.canvas));
        if (!at_edge.back()) has_free_copy[static_cast<std::size_t>(instance.figure)] = true;
        points.push_back(std::move(point));
    }
    // a figure that is met only where it ends at the picture's edge is a piece that was cut there before it was drawn
    for (std::size_t i = 0; i < points.size() && !options.tile; ++i)
        if (at_edge[i] && !has_free_copy[static_cast<std::size_t>(drawing.instances[i].figure)]) points[i].whole = false;
    sort_pieces(points, kinds.names);
    return make_exemplar(points, kinds.names, options, label);
}

}  // namespace rinceau
