#pragma once
// No outline over another one, nor over a boundary line (not in the paper, which looks at centres only).

#include "growth/arrangement/growth_ground.h"

namespace rinceau {

/// Of each two elements whose outlines overlap: pushes them apart if little is missing; else exchanges one for another of
/// its kind whose outline fits there; else pushes them apart further. Ends when none overlap or after a bounded number of
/// rounds.
void untangle_outlines(ElementArrangement& arrangement, const GrowthGround& ground);

/// Takes out what still overlaps, as few as can be told, smaller ones first.
void drop_overlapping(ElementArrangement& arrangement, const GrowthGround& ground);

/// Elements whose outlines are cut by a boundary line are exchanged for others of their kind that are not, or taken out.
void drop_cut(ElementArrangement& arrangement, const GrowthGround& ground);

}  // namespace rinceau
