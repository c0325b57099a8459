#pragma once
// A region of the plane as triangles.

#include <array>
#include <vector>

#include "scene/painted_region.h"

namespace rinceau {

struct RegionTriangles {
    std::vector<Point> points;                  ///< the region's corners, each place once
    std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise
    std::vector<std::array<int, 2>> borders;    ///< edges of one triangle, which lies on their left
};

/// The constrained Delaunay triangulation: no other corners than the region's, every edge of the region is an edge of
/// triangles, and the triangles are as little pointed as that allows. Corners nearer than 1e-9 of the extent count as one.
/// Where an edge runs through a corner of another, it is cut there. Edges that cross by more than that rounding make the
/// result uncertain near the crossing. No triangles for a region without area. O(n log n) but for very long edges.
RegionTriangles region_triangles(const Region& region);

}  // namespace rinceau
