#pragma once
// What growth in a single pass leaves behind: too many of a kind, elements too close, holes (not in the paper).

#include "growth/arrangement/arrangement_mesh.h"
#include "growth/arrangement/choose_reference.h"

namespace rinceau {

/// Of each symbol that stands more densely than in the exemplar, takes most of the surplus out, worst fitting first, no two
/// neighbours. Counts only what is inside the mesh.
void thin_out(ElementArrangement& arrangement, const GrowthGround& ground, const ArrangementMesh& mesh);

/// Of two elements that are nearer than `share` of their least distance takes out the smaller one.
void drop_crowded(ElementArrangement& arrangement, const GrowthGround& ground, double share);

/// How large a hole may be, as the exemplar's are.
struct HoleLimits {
    double empty = 0;  ///< radius of a circle without a centre
    double gap = 0;    ///< radius of a circle that is clear of the circles about elements
};
/// The largest of the exemplar, `slack` times.
HoleLimits hole_limits(const GrowthGround& ground, double slack);

/// Places an element in each hole beyond the limits, where one fits: at no less than `share` of the least distances and, if
/// `clear`, with no outline over another one. Places where growth can go on are no holes. Returns the new elements, linked
/// with those around them.
std::vector<int> fill_holes(ElementArrangement& arrangement, const GrowthGround& ground, const ArrangementMesh& mesh,
                            const HoleLimits& limits, double share, bool clear);

}  // namespace rinceau
