#pragma once
// Which outlines share area.

#include <span>
#include <utility>
#include <vector>

#include "geometry/similarity.h"
#include "scene/painted_region.h"

namespace rinceau {

struct PlacedOutline {
    const Region* outline = nullptr;
    Similarity pose;  ///< outline -> scene
};

Region placed_region(const Region& region, const Similarity& pose);

/// Pairs of indices, lower first, sorted, of outlines that share more than `share` of the smaller one's area.
std::vector<std::pair<int, int>> overlapping_pairs(std::span<const PlacedOutline> outlines, double share);

}  // namespace rinceau
