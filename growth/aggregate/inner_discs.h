#pragma once
// Discs that stand for a shape where a polygon would be too slow to move (settling a shape into its gap).

#include <cstddef>
#include <vector>

#include "growth/aggregate/exclusive_region.h"
#include "scene/painted_region.h"

namespace rinceau {

/// At most `max_count` discs inside the region, largest first, every one about a point that no larger one nearly covers. A
/// region with area has at least one.
std::vector<InnerDisc> inner_discs(const Region& region, std::size_t max_count = 28);

}  // namespace rinceau
