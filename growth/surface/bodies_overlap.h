#pragma once
// Do two bodies in space overlap? In double precision; touching is no overlap.

#include "growth/surface/collision_body.h"

namespace rinceau {

/// The exact test of two bodies, both shrunk by their factor (1 = as they are) about their centres; without a broad phase.
/// Boxes by separating axes. Of discs and hulls the elliptic or polygonal prisms with rounded rims (GJK); outlines of nearly
/// parallel bodies by their polygons seen along the common normal, others by their boxes. Where the normals of the surface
/// are opposed (both faces of a thin sheet) only what lies above it counts. Contact not deeper than a billionth of the size
/// counts as touching.
bool bodies_overlap(const CollisionBody& a, const CollisionBody& b, double shrink_a, double shrink_b);

/// The part that works on boxes alone.
bool boxes_overlap(const CollisionBody& a, const CollisionBody& b, double shrink_a, double shrink_b);

}  // namespace rinceau
