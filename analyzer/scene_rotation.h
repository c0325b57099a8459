#pragma once
// Rotations of the whole drawing, found from the top (docs/analysis.md, 4.6): steps between neighbours do not see a rotation
// about a far centre, one map of the plane does.

#include <optional>
#include <vector>

#include "analyzer/search_state.h"

namespace rinceau {

struct SceneRotation {
    Point centre;
    int fold = 2;                          ///< turns by 2 pi / fold
    std::vector<std::vector<int>> orbits;  ///< items, each orbit in order of the rotation, `fold` different items
    double saved_bits = 0;                 ///< (fold - 1) items of each orbit need not be written
};

/// The rotation that saves most, if any moves at least half of the items.
std::optional<SceneRotation> find_scene_rotation(const SearchState& state);

}  // namespace rinceau
