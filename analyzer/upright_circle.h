#pragma once
// Members on a circle that all keep their heading, as the stars of a flag or the cabins of a big wheel: a linear rule (Stava
// et al. 2010, eq. 4) whose alpha and beta change by opposite amounts (docs/analysis.md, 4.1 and 7).

#include <span>
#include <utility>
#include <vector>

#include "analyzer/chains.h"

namespace rinceau {

/// Chains of five or more items of one heading, whose way turns by `turn_change` (radians) from step to step, each found
/// from one of the start pairs. Those that come round are closed and begin at their lowest element; other ones of their kind
/// begin where their first step is that of the longest one, if one of their steps is. Not disjoint.
std::vector<LinearChain> upright_chains(const RuleSet& rules, const PoseGrid& grid,
                                        std::span<const std::pair<int, int>> starts, double turn_change,
                                        const PoseTolerance& tolerance);

/// The middle of the circle, in the frame of the first member of an upright rule.
Point circle_centre(const Rule& rule);

/// Does the upright rule come round with its `count`-th member?
bool comes_round(const Rule& rule, int count);

}  // namespace rinceau
