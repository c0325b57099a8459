#pragma once
// Slides and turns a shape into a gap before anything exact is asked: a field and inner discs are all it knows.

#include <optional>

#include "growth/aggregate/distance_field.h"
#include "growth/aggregate/exclusive_region.h"
#include "growth/aggregate/pack_pose.h"

namespace rinceau {

/// From `start` to where no inner disc is nearer to anything than its radius and `clearance`, to within a cell; none if that
/// is not found within some steps. The scale stays; the turn stays within what is allowed.
std::optional<PackPose> settled(const DistanceField& field, const ExclusiveRegion& region, const PackPose& start,
                                const PackAngles& angles, double clearance);

}  // namespace rinceau
