#pragma once
// Relaxation of everything that has grown (Ijiri et al. 2008, section 5.5).

#include "growth/arrangement/growth_ground.h"

namespace rinceau {

/// The least of eq. 5 over the positions of all nodes that are not held; of each part that hangs together without a held
/// node, the first node stays where it is (eq. 6). In mode rotate angles and positions take turns `rounds` times. The energy
/// never rises. Boundary lines do not count. In mode flow it must not be used: a curved flow has no room for equal
/// distances.
void relax_all(ElementArrangement& arrangement, const GrowthGround& ground, int rounds);

}  // namespace rinceau
