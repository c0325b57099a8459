#pragma once
// Geodesic polar coordinates about a point, by Dijkstra's order with label correction over triangles unfolded at the source
// (after Melvaer & Reimers 2012; section 4.2 of Li et al. 2010 uses fast marching instead).

#include <vector>

#include "growth/surface/surface_point.h"

namespace rinceau {

/// Distance and direction from the source of the vertices within the radius (and of no others).
struct PolarMap {
    SurfacePoint source;
    double radius = 0;
    std::vector<int> vertices;  ///< by rising distance
    std::vector<double> distance;
    std::vector<double> angle;  ///< radians counter-clockwise from the x axis of the source's face frame, in (-pi, pi]
};

/// `radius` may be infinite. Work is proportional to what lies within.
PolarMap polar_map(const SurfaceMesh& surface, SurfacePoint source, double radius);
/// The same about a vertex; angles are those of the vertex's frame.
PolarMap polar_map_of_vertex(const SurfaceMesh& surface, int vertex, double radius);

}  // namespace rinceau
