#pragma once
// Delaunay triangulation: no corner of any triangle lies inside the circle about another one.

#include <array>
#include <span>
#include <vector>

#include "geometry/point.h"

namespace rinceau {

struct DelaunayTriangle {
    std::array<int, 3> corners{};    ///< points, counter-clockwise
    std::array<int, 3> neighbors{};  ///< triangle across the edge from corner k to the next one; -1 = none, the hull
};

/// Triangles over the convex hull of the points, sorted by their lowest corner, which comes first, then by the others.
/// Points are snapped to a grid of 1e-9 of their extent, and what is said here holds for the snapped ones. Of points that
/// fall into one the first is used, the others are in no triangle. Where more than three points lie on an empty circle, the
/// polygon that they form is cut into triangles that share its lowest point. No triangles for points on a line, or fewer
/// than three. All coordinates must be finite. O(n log n).
std::vector<DelaunayTriangle> delaunay(std::span<const Point> points);

}  // namespace rinceau
