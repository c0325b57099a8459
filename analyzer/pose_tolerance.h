#pragma once
// When two poses count as equal (docs/analysis.md, 4): recognition, not robustness.

#include <algorithm>
#include <cmath>

#include "geometry/similarity.h"

namespace rinceau {

struct PoseTolerance {
    double size = 0.01;          ///< position, in sizes of the element
    double angle = 0.01;         ///< angle and log scale of an element of radius 1
    double per_distance = 0.05;  ///< of `size`, for each unit of distance from the element that the pose is predicted from

    /// Allowed shift of a pose of scale `scale`, predicted over `distance` (scene lengths).
    double shift(double scale, double distance) const { return size * scale + per_distance * size * distance; }
    /// Allowed |a - a'| of unit linear parts for a part of the given radius: an angular error moves its rim.
    double turn(double radius) const { return 1.5 * angle / std::max(1.0, 0.6 * radius); }
};

}  // namespace rinceau
