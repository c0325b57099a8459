#pragma once
// The sweep of the GLU tessellator, which works without a context: few corners at a time, as its time grows with the square.

#include <cstdint>
#include <vector>

#include "editor/mesh/cut_contours.h"
#include "scene/style.h"

namespace rinceau {

struct Triangles {
    std::vector<Point> points;
    std::vector<std::uint32_t> indices;  ///< three a triangle, counter-clockwise
};

/// The inside of the contours by the rule as triangles that do not overlap. All points must be finite.
Triangles swept_triangles(const Contours& contours, FillRule rule);

/// The outline of that inside: contours that do not cross, counter-clockwise about it and clockwise about its holes.
Contours swept_outline(const Contours& contours, FillRule rule);

}  // namespace rinceau
