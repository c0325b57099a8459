#pragma once
// Round values for places in the axiom: scale 1 and angles that are multiples of 15 degrees where the drawing allows them.

#include "analyzer/rule_model.h"

namespace rinceau {

/// The pose of a root item, or a near one whose turtle (pose * anchor) has a natural scale and angle, its place fitted anew,
/// if no element below then lies farther off than `allowed` (scene length), outlines reaching out to twice their radius.
Similarity natural_pose(const RuleSet& rules, int root, const Similarity& anchor, double allowed);

/// The nearest multiple of 15 degrees, if it is near; else the angle itself.
double natural_angle(double angle);

}  // namespace rinceau
