#pragma once
// Places and directions on a surface.

#include <array>
#include <vector>

#include "geometry/random.h"
#include "growth/surface/surface_mesh.h"

namespace rinceau {

/// In the frame of its face; always in the face, to rounding.
struct SurfacePoint {
    int face = 0;
    Complex at;
};

/// Weights of the three corners; they sum to 1.
std::array<double, 3> barycentric(const SurfaceMesh& surface, SurfacePoint p);
SurfacePoint from_barycentric(const SurfaceMesh& surface, int face, const std::array<double, 3>& weights);

SpacePoint position_in_space(const SurfaceMesh& surface, SurfacePoint p);
/// A direction of the face's frame, in space; as long as it was.
SpacePoint direction_in_space(const SurfaceMesh& surface, int face, Complex direction);
/// The vertex normals, interpolated; of length 1.
SpacePoint normal_at(const SurfaceMesh& surface, SurfacePoint p);

/// The vertex, as a corner of the face of outgoing[v].
SurfacePoint at_vertex(const SurfaceMesh& surface, int v);
/// A direction of the vertex's frame, in the frame of the face of at_vertex(); only the angle between neighbouring edges is
/// kept where the vertex is curved.
Complex from_vertex_frame(const SurfaceMesh& surface, int v, Complex direction);

/// Spread evenly over the area.
SurfacePoint random_surface_point(const SurfaceMesh& surface, Random& random);

}  // namespace rinceau
