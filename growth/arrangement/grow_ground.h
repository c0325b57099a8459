#pragma once
// Growth over a whole ground, also over parts of it that lines separate from each other.

#include "growth/arrangement/grow_arrangement.h"

namespace rinceau {

/// The place of the ground that is farthest from all boundary lines, the nearest to its middle if there are several; the
/// middle, if there are no lines. The ground is not empty.
Point ground_start(const ArrangeSurroundings& around, const Box& ground);

/// Grows from ground_start() until the order is fulfilled or nothing more can grow, then from a seed in the middle of each
/// part of the ground that it has not come to. What the order's brush says holds. Nothing but the boundary keeps growth
/// within the ground.
ElementArrangement grown_over(ElementArrangement arrangement, const Exemplar& exemplar, const ArrangeSurroundings& around,
                              const Box& ground, const GrowOrder& order, const Progress& progress = {});

}  // namespace rinceau
