#pragma once
// An irregular arrangement is read anew: who is whose neighbour, and which reference explains each ring best (not in the
// paper, whose growth never looks back).

#include "growth/arrangement/arrangement_mesh.h"
#include "growth/arrangement/choose_reference.h"

namespace rinceau {

/// Links become those of the mesh, which must be of the arrangement as it stands. An element whose neighbours are the same
/// and that fits stays what it is; of the others each gets the reference of its symbol that fits best. Positions stay.
void reread_rings(ElementArrangement& arrangement, const GrowthGround& ground, const ArrangementMesh& mesh);

/// The same, but every element stays what it is: only its places are matched anew.
void relink_rings(ElementArrangement& arrangement, const GrowthGround& ground, const ArrangementMesh& mesh);

/// How badly an element's ring fits, in mean edges: what its places are off in the mean square; a neighbour without a place
/// counts as one that is as far off as a place can be.
double ring_misfit(const ElementArrangement& arrangement, const GrowthGround& ground, int element);

}  // namespace rinceau
