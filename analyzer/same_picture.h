#pragma once
// Do a drawing and what a grammar draws look the same? (docs/analysis.md, 8)

#include <vector>

#include "analyzer/overlaps.h"
#include "geometry/progress.h"
#include "scene/element.h"

namespace rinceau {

/// For scenes of the same elements, but for the paint order of some pairs: those of `scene` in `exchanged`. Painted 900
/// pixels wide, at most 0.2 % of the inked pixels differ, by more than an eighth of the range, from every pixel next to
/// them. `threads`: 0 = one per processor.
bool same_picture(const Scene& scene, const Scene& drawn, const std::vector<OverlapPair>& exchanged, int threads = 0,
                  const Progress& progress = {});

}  // namespace rinceau
