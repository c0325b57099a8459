#pragma once
// Keeping outlines off boundary lines (Ijiri et al. 2008, section 3; there only centres are kept).

#include "growth/arrangement/growth_ground.h"

namespace rinceau {

/// Does a boundary line cut the outline of the exemplar's element, placed at `at` and turned by `angle`?
bool is_cut(const GrowthGround& ground, int reference, double angle, Point at);

/// The place next to `at` where the outline is clear of the lines that it reached into: by as much as it reached over each,
/// a few times over. In a corner that is too narrow it still reaches over one of them afterwards.
Point pushed_inside(const GrowthGround& ground, int reference, double angle, Point at);

/// Would a push that leads there crowd the element: nearer to another one than the exemplar has them? Asked along a flow,
/// where outlines may overlap: nothing else keeps elements that a wall turns back from piling up. `node` itself does not
/// count; nor, if it is an element, those that it is no nearer to than it was.
bool is_crowded(const ElementArrangement& arrangement, const GrowthGround& ground, int node, int reference, Point to);

/// Moves elements among the nodes off the lines; no move leads over a line, or crowds.
void push_inside(ElementArrangement& arrangement, const GrowthGround& ground, const std::vector<int>& nodes);

}  // namespace rinceau
