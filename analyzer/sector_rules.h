#pragma once
// A rotation of the whole drawing as the rule above all others: one sector is analysed and turned about the centre
// (docs/analysis.md, 4.6).

#include "analyzer/generate_rules.h"
#include "analyzer/scene_rotation.h"

namespace rinceau {

/// An opening (openings.h): rules of one sector and a ring of the sector; what the rotation does not move is left to the
/// search. `state` is a starting_state.
SearchState open_with_sectors(SearchState state, const SceneRotation& rotation, const SearchOptions& options,
                              const Progress& progress = {});

}  // namespace rinceau
