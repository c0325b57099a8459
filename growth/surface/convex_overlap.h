#pragma once
// Do two convex bodies overlap? By their support points (Gilbert, Johnson, Keerthi 1988).

#include "growth/surface/collision_body.h"

namespace rinceau {

/// Discs, hulls, boxes; an outline counts as its box. Contact not deeper than a billionth of the size is touching. The
/// answer may be either within that depth.
bool convex_bodies_overlap(const CollisionBody& a, const CollisionBody& b, double shrink_a, double shrink_b);

}  // namespace rinceau
