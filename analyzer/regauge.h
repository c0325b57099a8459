#pragma once
// Choosing another one of an item's symmetry-equivalent poses (docs/analysis.md, 4).

#include "analyzer/rule_model.h"

namespace rinceau {

/// The pose, among those that the part's symmetry makes equivalent to `pose`, that is nearest to `wanted`.
Similarity nearest_pose(const Part& part, const Similarity& pose, const Similarity& wanted);

/// Gives the item the pose `frame`, which is its pose times one of its part's symmetries (for a continuous part any turned
/// pose), and brings its members into the order and poses of the part's children seen from there, all the way down. Gaps and
/// what stands in for a member stay where they are in the scene.
void regauge(RuleSet& rules, int item, const Similarity& frame);

}  // namespace rinceau
