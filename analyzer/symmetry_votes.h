#pragma once
// Where the whole drawing may be its own image (docs/analysis.md, 4.6): equal copies vote for turns about a centre and for
// mirror axes. Steps between neighbours do not see these, one map of the plane does.

#include <vector>

#include "analyzer/search_state.h"

namespace rinceau {

/// A point group: turns by 2 pi / fold about the centre and, if mirrored, `fold` mirror axes through it.
struct PointGroup {
    Point centre;
    int fold = 1;
    bool mirrored = false;
    Complex axis{1, 0};  ///< unit, along one of the mirror axes

    std::size_t order() const { return static_cast<std::size_t>(fold) * (mirrored ? 2 : 1); }
    /// Its maps of the plane, 0 <= k < order(), the identity first. Mirrored: 2k turns k times, 2k + 1 mirrors before that.
    Similarity map(std::size_t k) const;
};

/// The reflection about the line through `through` along the unit `axis`.
Similarity reflection(Point through, Complex axis);

/// Turns about a centre and single mirror axes (fold 1), most voted first. Listed items only; bounded work.
std::vector<PointGroup> vote_for_point_groups(const SearchState& state);

}  // namespace rinceau
