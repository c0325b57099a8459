#pragma once
// The largest circle in which nothing stands.

#include <vector>

#include "growth/aggregate/pack_domain.h"
#include "growth/measure/point_pattern.h"

namespace rinceau {

struct EmptyCircle {
    Point center;
    double radius = 0;
};

/// The largest circle without a point in it that lies in the window, `inward` or more from its rim; exact but for the raster
/// of the window. Radius 0 if there is none.
EmptyCircle largest_empty_circle(const PointPattern& pattern, double inward);

/// The largest circle in the domain that meets none of the regions; regions near the edge of a tile stand on the other side,
/// too. To within 1e-3 of its radius, found from a raster of the domain.
EmptyCircle largest_gap(const std::vector<Region>& regions, const PackDomain& domain);

}  // namespace rinceau
