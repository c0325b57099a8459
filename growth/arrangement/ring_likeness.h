#pragma once
// Are the neighbourhoods of an exemplar alike, as on a lattice, or each different? Internal to the folder.

#include <span>
#include <vector>

#include "growth/arrangement/connectivity.h"

namespace rinceau {

/// Share of the inner points whose ring is met again at a fifth of the other inner points (three at least): as many
/// neighbours, each within a quarter of the spacing of the same place in the root mean square. 1 on a lattice, also with a
/// motif of a few points, near 0 for scattered points. 0 without such points.
double alike_rings(std::span<const Point> points, const Connectivity& connectivity);

}  // namespace rinceau
