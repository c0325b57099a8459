// Exemplars from drawings: figures are elements, sorted into kinds.

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

}  // namespace

Exemplar make_exemplar(const FiguredDrawing& drawing, const ExemplarOptions& options, const std::string& label) {
    const ElementKinds kinds = element_kinds(drawing);
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
    return make_exemplar(points, kinds.names, options, label);
}

}  // namespace rinceau
