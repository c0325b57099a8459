#pragma once
// Which pairs of elements overlap so that their paint order can be seen (docs/analysis.md, 8).

#include <cstddef>
#include <vector>

#include "geometry/progress.h"
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
    /// Unless antialiasing counts: the other pairs that touch or nearly so. Their order changes the picture only in how
    /// pixels on common edges are antialiased, which makes a line a trace lighter or darker. Worth keeping where it costs
    /// nothing. Sorted the same way.
    std::vector<OverlapPair> faint;
    bool complete = true;  ///< false: more than max_pairs; the rest was left out by distance in paint order
};

struct OverlapOptions {
    std::size_t max_pairs = 4'000'000;
    /// The order must be seen in a picture this many pixels wide. In drawings with tiny things, those are shown larger: an
    /// element's diagonal never has less than 4 pixels.
    double picture_width = 900;
    /// A renderer mixes colours where edges pass through a pixel, in paint order: where edges coincide, as in tilings, a
    /// line gets a trace lighter or darker. No eye sees it, a comparison of pixels does. True: such pairs are listed like
    /// the rest.
    bool antialiasing = true;
    /// Points that are looked at in all; pairs left over then count as visible if they come within a pixel's share of each
    /// other.
    std::size_t max_samples = 100'000'000;
    int threads = 0;  ///< 0 = one per processor; the result is the same for any number
};

/// All pairs of elements whose painted regions come within half a pixel of each other, dashes taken as solid, except those
/// that paint one and the same colour. Without antialiasing only those whose order can be seen (visible_order.h) in the
/// drawing's picture: exchanged, the two alone give another picture; elements that only touch, have the same colour where
/// they overlap, or overlap by a fraction of a pixel are not in `pairs`. A verbatim element fills its box; of unknown
/// extent, it overlaps everything; its order always counts.
Overlaps find_overlaps(const Scene& scene, const OverlapOptions& options = {}, const Progress& progress = {});

}  // namespace rinceau
