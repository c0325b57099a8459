#pragma once
// The triangles that an arrangement's elements and seeds form, as the exemplar's were made (Ijiri et al. 2008, section 4).

#include <vector>

#include "growth/arrangement/connectivity.h"
#include "growth/arrangement/growth_ground.h"

namespace rinceau {

struct ArrangementMesh {
    std::vector<int> nodes;  ///< by point
    std::vector<Point> points;
    Connectivity connectivity;  ///< no face has an edge over a boundary line or one that is far longer than the exemplar's
};

ArrangementMesh mesh_of(const ElementArrangement& arrangement, const GrowthGround& ground);

/// The points move to where the nodes are now; faces stay.
void move_points(ArrangementMesh& mesh, const ElementArrangement& arrangement);

/// Seeds that stand so near to an element that no other one fits between are taken out: they have lost their place.
void drop_covered_seeds(ElementArrangement& arrangement, const GrowthGround& ground);

}  // namespace rinceau
