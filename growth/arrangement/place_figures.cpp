#include "growth/arrangement/place_figures.h"

namespace rinceau {

std::vector<PlacedFigure> placed_figures(const FiguredDrawing& drawing, const std::vector<ArrangedElement>& elements) {
    std::vector<PlacedFigure> placed;
    placed.reserve(elements.size());
    for (const ArrangedElement& element : elements) {
        // Of a tiled exemplar, references beyond the instances are their copies in other tiles.
        const std::size_t copied = static_cast<std::size_t>(element.reference) % drawing.instances.size();
        const FigureInstance& instance = drawing.instances[copied];
        Similarity pose = rotate(element.angle) * instance.pose;
        pose.translation = element.position;
        placed.push_back({instance.figure, pose, {}});
    }
    return placed;
}

Region placed_outline(const FiguredDrawing& drawing, const PlacedFigure& placed) {
    Region outline = drawing.figures[static_cast<std::size_t>(placed.figure)].outline;
    for (std::vector<Point>& ring : outline) {
        for (Point& p : ring) p = apply(placed.pose, p);
    }
    return outline;
}

}  // namespace rinceau
