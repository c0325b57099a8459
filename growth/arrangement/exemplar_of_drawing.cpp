// Exemplars from drawings: figures are elements, sorted into kinds.

#include "growth/arrangement/exemplar.h"
#include "growth/arrangement/kinds.h"

namespace rinceau {

Exemplar make_exemplar(const FiguredDrawing& drawing, const ExemplarOptions& options, const std::string& label) {
    const ElementKinds kinds = element_kinds(drawing);
    std::vector<ExemplarPoint> points;
    for (std::size_t i = 0; i < drawing.instances.size(); ++i) {
        const FigureInstance& instance = drawing.instances[i];
        ExemplarPoint point{.position = instance.pose.translation, .symbol = kinds.of_instance[i], .whole = instance.whole};
        Similarity about_position = instance.pose;
        about_position.translation = {};
        point.outline = drawing.figures[static_cast<std::size_t>(instance.figure)].outline;
        for (auto& polygon : point.outline)
            for (Point& corner : polygon) corner = apply(about_position, corner);
        points.push_back(std::move(point));
    }
    return make_exemplar(points, kinds.names, options, label);
}

}  // namespace rinceau
