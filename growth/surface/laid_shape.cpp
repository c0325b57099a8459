#include "growth/surface/laid_shape.h"

#include <algorithm>

namespace rinceau {

void bound_shape(const SurfaceMesh& surface, LaidShape& shape) {
    std::vector<SpacePoint> corners;
    for (const LaidLayer& layer : shape.layers)
        for (const LaidPiece& piece : layer.area.pieces)
            for (int k = piece.first; k < piece.first + piece.count; ++k)
                corners.push_back(position_in_space(surface, {piece.face, layer.area.corners[static_cast<std::size_t>(k)]}));
    const auto [low, high] = bounds(TriangleMesh{corners, {}});
    shape.centre = 0.5 * (low + high);
    shape.radius = 0;
    for (const SpacePoint& p : corners) shape.radius = std::max(shape.radius, abs(p - shape.centre));
}

}  // namespace rinceau
