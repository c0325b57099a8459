#pragma once
// A polyline as a turtle walks it. Internal to the folder.

#include <vector>

#include "geometry/point.h"

namespace rinceau {

/// Turn to the left by `turn` degrees, then go `length`.
struct WalkStep {
    double turn = 0;    ///< in (-180, 180]
    double length = 0;  ///< > 0, but for a first step that stays at the start
};

/// From the origin, heading +y, to the first corner and on to the others: as many steps as corners, without those that stay
/// where they are (the first is never left out).
std::vector<WalkStep> walk_along(const std::vector<Point>& corners);

}  // namespace rinceau
