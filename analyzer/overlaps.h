#pragma once
// Which pairs of elements touch, so that their paint order can be seen (ANALYZER section 9).

#include <vector>

#include "scene/element.h"

namespace rinceau {

/// lower is painted before upper in the drawing.
struct OverlapPair {
    int lower = 0;
    int upper = 0;
    friend constexpr bool operator==(const OverlapPair&, const OverlapPair&) = default;
};

struct Overlaps {
    std::vector<OverlapPair> pairs;  ///< sorted by (upper, lower)
    bool complete = true;            ///< false: more than max_pairs; the rest was left out by distance in paint order
};

struct OverlapOptions {
    std::size_t max_pairs = 4'000'000;
};

/// All pairs of elements whose painted regions (fill, stroke with its width) come within half a pixel-thousandth of the
/// diagonal of each other, except pairs for which the order cannot be seen: the same single opaque colour all over.
/// Elements that fill a region count as solid; verbatim elements of unknown extent overlap everything.
Overlaps find_overlaps(const Scene& scene, const OverlapOptions& options = {});

}  // namespace rinceau
