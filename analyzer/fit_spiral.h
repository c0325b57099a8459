#pragma once
// The spiral law that a set of points follows (docs/analysis.md, 4.6): grown from the innermost points outward, so that no
// neighbourhood has to be known; neighbours on the page are not neighbours in the spiral.

#include <optional>
#include <span>
#include <vector>

#include "analyzer/spiral_law.h"

namespace rinceau {

struct SpiralFit {
    SpiralLaw law;           ///< angle, reach, power and start (direction 1); lengths as in the points
    Similarity pivot;        ///< frame of the pivot, unscaled
    std::vector<int> order;  ///< order[k] is the point with index start + k
    double worst = 0;        ///< largest distance of a point from its place
};

/// The spiral with the most points, at least 16, whose angle is neither near 0 nor near half a turn (those are rows); or
/// nothing. `slack` is the distance that a point may lie farther off for round numbers. Points may be in any order and there
/// may be others among them. O(n log n).
std::optional<SpiralFit> fit_spiral(std::span<const Point> points, double slack);

/// The fit for points that are not the places themselves: what stands in place k is points[order[k]] + linear[k] * seat,
/// seat being unknown. Never worse than `fit`.
SpiralFit fit_seats(std::span<const Point> points, std::span<const Complex> linear, const SpiralFit& fit, double slack);

}  // namespace rinceau
