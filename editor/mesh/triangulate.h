#pragma once
// Polygons that may cross themselves as triangles that do not overlap.

#include <cstdint>
#include <vector>

#include "geometry/point.h"
#include "scene/style.h"

namespace rinceau {

/// Corners in order, the last joined to the first.
using Contours = std::vector<std::vector<Point>>;

struct Triangles {
    std::vector<Point> points;
    std::vector<std::uint32_t> indices;  ///< three a triangle, counter-clockwise
};

/// The inside of the contours by the rule. All points must be finite.
Triangles triangulated(const Contours& contours, FillRule rule);

}  // namespace rinceau
