#pragma once
// Faces of more than three corners as triangles.

#include <span>
#include <vector>

#include "growth/mesh/triangle_mesh.h"

namespace rinceau {

/// Triangles over the polygon's own corners, turning as it does; corners - 2 of them. Quads are cut along the diagonal that
/// keeps both halves outward, the shorter one if both do; larger polygons ear by ear, as they are seen along their mean
/// normal. `corners` are at least three indices of positions.
std::vector<std::array<int, 3>> split_polygon(std::span<const SpacePoint> positions, std::span<const int> corners);

}  // namespace rinceau
