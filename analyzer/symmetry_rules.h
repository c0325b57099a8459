#pragma once
// A symmetry of the whole drawing as the rule above all others: one sector, or one half, is analysed and turned or mirrored
// (docs/analysis.md, 4.6).

#include "analyzer/generate_rules.h"
#include "analyzer/scene_symmetry.h"

namespace rinceau {

/// An opening (openings.h): rules of one half or sector, and of these the whole; what the symmetry leaves in place is left to
/// the search. `symmetry` was found in `state`.
SearchState open_with_symmetry(SearchState state, const SceneSymmetry& symmetry, const SearchOptions& options,
                               const Progress& progress = {});

}  // namespace rinceau
