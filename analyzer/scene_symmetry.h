#pragma once
// Symmetries of the whole drawing, found from the top (docs/analysis.md, 4.6): which items a turn about a centre or a mirror
// takes onto which.

#include <vector>

#include "analyzer/symmetry_votes.h"

namespace rinceau {

struct SceneSymmetry {
    PointGroup group;
    /// orbits[o][k] is the item that stands at group.map(k) times the pose of orbits[o][0]. Either all differ, or the item
    /// lies on a mirror axis: [1] is then [0] (on group.axis itself) or [order - 2] (on the axis half a sector further).
    /// Mirrored: [0] lies between these two axes.
    std::vector<std::vector<int>> orbits;
    double saved_bits = 0;  ///< what need not be written: all but one item of each orbit

    bool on_axis(const std::vector<int>& orbit) const {
        return group.mirrored && (orbit[1] == orbit[0] || orbit[1] == orbit[orbit.size() - 2]);
    }
};

/// The symmetries that save most bits, best first; each moves a good part of the listed items. Empty on most drawings.
std::vector<SceneSymmetry> find_scene_symmetries(const SearchState& state);

}  // namespace rinceau
