#pragma once
// Which drawn element stands for which element of the scene, for the independent check.

#include <vector>

#include "geometry/progress.h"
#include "scene/element.h"

namespace rinceau {

struct DrawnMatch {
    int drawn = -1;        ///< index into the drawn scene; -1 = nothing stands there
    double deviation = 0;  ///< of the outlines, scene length
    bool same_style = true;
};

/// One to one, nearest first, equal style before other style; elements that coincide are matched in paint order. Outlines
/// that deviate by 4 tolerances or more do not match. Verbatim elements match when they are equal byte for byte.
/// `tolerance` is a scene length; it is also what numbers of styles may differ by. Gradients are compared where they are
/// seen. `threads`: 0 = one per processor; the result is the same for any number.
std::vector<DrawnMatch> match_drawn(const Scene& scene, const Scene& drawn, double tolerance, int threads = 0,
                                    const Progress& progress = {});

}  // namespace rinceau
