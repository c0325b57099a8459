#pragma once
// Elements that came too close are pushed apart (not in the paper).

#include <vector>

#include "growth/arrangement/growth_ground.h"

namespace rinceau {

/// Pushes pairs of elements apart that are nearer than the least distance of their kinds in the exemplar, half the way each
/// (the whole way the one that is free, if the other is held), until none is or `passes` are done; first those that `nodes`
/// belong to, then those that were moved. No move leads over a boundary line, and outlines are moved off lines last. Of a
/// regular pattern along a flow distances do not tell: there only that is done.
void separate(ElementArrangement& arrangement, const GrowthGround& ground, const std::vector<int>& nodes, int passes);

}  // namespace rinceau
