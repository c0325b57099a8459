#pragma once
// How far inside a polygon a point lies, without the creases that the true distance has along the polygon's middle.

#include <vector>

#include "geometry/point.h"
#include "scene/painted_region.h"

namespace rinceau {

/// The region with its outer rings counter-clockwise and its holes clockwise.
Region oriented(Region region);

/// 0 on the outline, rising as fast as the true distance there, smooth inside; at the middle of a disc 1/pi of its radius.
/// `p` lies inside of an oriented region.
double smooth_inside_distance(const Region& region, Point p);

/// The true distance to the outline.
double outline_distance_at(const Region& region, Point p);

}  // namespace rinceau
