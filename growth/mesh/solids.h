#pragma once
// Closed meshes of simple bodies.

#include <vector>

#include "growth/mesh/triangle_mesh.h"
#include "scene/painted_region.h"

namespace rinceau {

/// What a profile encloses when it turns about the z axis: points (distance from the axis, z) from the bottom up, the first
/// and the last on the axis, the others off it. `around` >= 3 corners a turn, the first on the x axis.
TriangleMesh turned_solid(const std::vector<Point>& profile, int around);

/// The same of a closed profile off the axis, counter-clockwise: a ring.
TriangleMesh turned_ring(const std::vector<Point>& profile, int around);

/// The region from z = low to z = high > low: caps and walls. Empty for a region without area.
TriangleMesh extruded(const Region& region, double low, double high);

/// A convex polygon (counter-clockwise) from z = 0 to `height`, its upper edge cut off at 45 degrees by `bevel`, which is
/// positive and smaller than the height and than what the polygon can be shrunk by.
TriangleMesh bevelled_prism(const std::vector<Point>& polygon, double height, double bevel);

}  // namespace rinceau
