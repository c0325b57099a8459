#pragma once
// The isometries that map an outline onto itself, as an explicit group (docs/analysis.md, 1).

#include "analyzer/instancing.h"
#include "analyzer/moments.h"
#include "analyzer/outline_distance.h"

namespace rinceau {

/// Rotations first, by rising angle, then mirror images by rising angle. Every element maps the outline onto itself within
/// `distance` (unit frame). Groups of more than 48 rotations count as continuous if turns by odd angles pass the same
/// test; else they count as trivial.
SymmetryGroup symmetry_of(const Moments& moments, const FineOutline& outline, double distance);

}  // namespace rinceau
