#pragma once
// The frames of vertices as directions in space, for what comes from or goes to outside the surface.

#include "growth/surface/surface_mesh.h"

namespace rinceau {

/// The x axis of the frame of v, of length 1, at right angles to its normal. Where the surface is curved the frame's angles
/// are scaled and no axis fits all edges; this one fits them best.
SpacePoint vertex_axis(const SurfaceMesh& surface, int v);

/// A vector of the frame of v in space, tangent to the surface; as long as it was. `axis` is vertex_axis() of v.
SpacePoint from_vertex_to_space(const SurfaceMesh& surface, SpacePoint axis, int v, Complex vector);
/// The tangent part of a vector in the frame of v.
Complex from_space_to_vertex(const SurfaceMesh& surface, SpacePoint axis, int v, SpacePoint vector);

/// Turns a direction of h's face's frame into one of the frame of h's start, so that the middle of the corner stays the
/// middle: a factor of length 1.
Complex corner_to_vertex(const SurfaceMesh& surface, int h);

}  // namespace rinceau
