#pragma once
// Where and how a shape stands, with its angle told from the direction that angles are measured from.

#include "geometry/random.h"
#include "geometry/similarity.h"
#include "growth/aggregate/aggregate_options.h"

namespace rinceau {

struct PackPose {
    Point at;
    double scale = 1;
    double turn = 0;  ///< from +x, or from the flow's direction at `at`
};

Similarity similarity_of(const PackPose& pose, const PackAngles& angles);

/// One of the angles that are allowed, all alike.
double draw_turn(const PackAngles& angles, Random& random);
/// May shapes turn a little from where they are?
bool may_turn(const PackAngles& angles);
/// The nearest turn that is allowed, if may_turn().
double nearest_turn(const PackAngles& angles, double turn);

}  // namespace rinceau
