#pragma once
// The isometries that map an outline onto itself, as an explicit group (docs/analysis.md, 1).

#include "analyzer/instancing.h"
#include "analyzer/moments.h"
#include "analyzer/outline_distance.h"

namespace rinceau {

/// Rotations first, by rising angle, then mirror images by rising angle. Every element maps the outline onto itself within
/// `distance` (unit frame). An outline that turns by odd angles map onto itself within `round_distance` is a continuous
/// group: circles are drawn as curves that are 2.7e-4 radii off a circle, so that this one should let them pass at any size.
/// Other groups of more than 48 rotations count as trivial.
SymmetryGroup symmetry_of(const Moments& moments, const FineOutline& outline, double distance, double round_distance);

/// Do turns by odd angles map it onto itself within `distance` (unit frame)?
bool is_circular(const Moments& moments, const FineOutline& outline, double distance);

}  // namespace rinceau
