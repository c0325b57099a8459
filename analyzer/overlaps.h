#pragma once
// Which pairs of elements touch, so that their paint order can be seen (ANALYZER section 9).

#include <cstddef>
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
    /// Regions that come this near share pixels, whose colour depends on the order; share of the diagonal. The default is
    /// half a pixel where the drawing is a thousand pixels across. Never more than a twentieth of the smaller element's box.
    double margin = 5e-4;
};

/// All pairs of elements whose painted regions (fill by its fill rule, stroke with its width, dashes counted as solid) come
/// within the margin of each other, except pairs for which the order cannot be seen: everything that both paint has one and
/// the same colour. Pairs further apart than 1.5 margins are not listed. Opacity hides nothing: whatever paints counts.
/// A verbatim element fills its box; of unknown extent, it overlaps everything.
Overlaps find_overlaps(const Scene& scene, const OverlapOptions& options = {});

}  // namespace rinceau
