#pragma once
// Widths and dashes of strokes: do they grow with the copies of a shape, or are they the same in all sizes? People draw both
// ways: symbols that are scaled as a whole, and lines of one pen. A person sees one shape either way.

#include <cstdint>
#include <vector>

namespace rinceau {

/// The stroke of one element.
struct DrawnStroke {
    int shape = 0;
    std::uint64_t kind = 0;    ///< equal if the styles agree in all that is told without lengths
    double width = 1;          ///< scene length
    double dash_period = 0;    ///< sum of the dashes, scene length; 0 = solid
    double scale = 1;          ///< unit frame -> scene
    bool scales_only = false;  ///< the width cannot be fixed
};

/// The lengths that stand for those of one or more strokes, in the unit frame, or in the scene if `fixed`.
struct StrokeLengths {
    int group = -1;  ///< equal for strokes of one shape and kind that are drawn with these lengths
    double width = 1;
    double dash_period = 0;
    bool fixed = false;
};

/// Common lengths for as many strokes of a shape and kind as possible: either all of them scale or all are fixed, whichever
/// makes fewer groups; of equally many, they scale, unless other shapes are drawn in strokes of the same kind and fixed
/// width. No width changes by more than `smallest_seen` (scene length), nor by more than 5 %; no period by more than 0.1 %.
std::vector<StrokeLengths> common_stroke_lengths(const std::vector<DrawnStroke>& strokes, double smallest_seen);

}  // namespace rinceau
