#pragma once
// Relaxation of the neighbourhood of what is new (Ijiri et al. 2008, section 5.5).

#include <vector>

#include "growth/arrangement/growth_ground.h"

namespace rinceau {

/// The sum of eq. 5 over all places that are filled, in squares of scene lengths.
double ring_energy(const ElementArrangement& arrangement);

/// Node and what is within `links` links of it, farthest first; by the order of links.
std::vector<int> nodes_around(const ElementArrangement& arrangement, int node, int links);

/// Moves each of the nodes, in this order, to where eq. 5 is least while all others stand still. Held nodes and moves over a
/// boundary line, and along a flow into another outline, are left out. The energy never rises.
void relax_in_turn(ElementArrangement& arrangement, const GrowthGround& ground, const std::vector<int>& nodes);

/// In modes rotate and flow: the angles of the elements follow what surrounds them or the flow, and their targets turn with
/// them. In mode rotate the energy does not rise.
void refit_angles(ElementArrangement& arrangement, const GrowthGround& ground, const std::vector<int>& nodes);

}  // namespace rinceau
