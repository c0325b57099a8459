#pragma once
// The convex hull of points of the plane.

#include <span>
#include <vector>

#include "geometry/point.h"

namespace rinceau {

/// Its corners, counter-clockwise from the one of lowest x (of these, lowest y); none lies between two others. Of points on
/// a line the two ends, of equal points one. Exact (Andrew 1979).
std::vector<Point> convex_hull(std::span<const Point> points);

}  // namespace rinceau
