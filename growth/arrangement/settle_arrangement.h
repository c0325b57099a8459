#pragma once
// Relaxation with all that it must respect: distances and boundary lines (Ijiri et al. 2008, section 5.5).

#include "growth/arrangement/growth_ground.h"

namespace rinceau {

/// After a new element: what is within two links of it.
void settle_near(ElementArrangement& arrangement, const GrowthGround& ground, int element);

/// Everything; `rounds` as relax_all has them. Along a flow by sweeps over the nodes, which leave the density as it is.
void settle_all(ElementArrangement& arrangement, const GrowthGround& ground, int rounds, int separation_passes = 20);

}  // namespace rinceau
