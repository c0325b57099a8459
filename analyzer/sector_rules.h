#pragma once
// A rotation of the whole drawing as the rule above all others: one sector is analysed and turned about the centre
// (docs/analysis.md, 4.6).

#include "analyzer/generate_rules.h"
#include "analyzer/scene_rotation.h"

namespace rinceau {

/// Rules of one sector, a ring of the sector, and rules of what the rotation does not move. `state` is a starting_state.
SearchState generate_sector_rules(SearchState state, const SceneRotation& rotation, const SearchOptions& options,
                                  const Progress& progress = {});

}  // namespace rinceau
