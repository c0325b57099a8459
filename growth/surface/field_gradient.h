#pragma once
// How a field changes along the surface (Li et al. 2010, section 4.3.2).

#include "growth/surface/surface_field.h"

namespace rinceau {

/// The change of a vector along x and y of the frame of a face. Constant over the face but for closed forms of the plane.
struct VectorGradient {
    Complex by_x, by_y;
};

/// Of the vectors of a field with n = 1; else of the unit major eigenvectors (or arms of the crosses) whose branch at p is
/// nearest to `branch`, a direction of the face's frame.
VectorGradient vector_gradient(const FieldOnSurface& field, SurfacePoint p, Complex branch);
/// The gradient of the same vectors turned left by a right angle: from major to minor eigenvectors.
constexpr VectorGradient turned_left(const VectorGradient& gradient) {
    return {Complex{0, 1} * gradient.by_x, Complex{0, 1} * gradient.by_y};
}

constexpr double divergence(const VectorGradient& gradient) { return gradient.by_x.x + gradient.by_y.y; }
/// Counter-clockwise seen from outside is positive.
constexpr double curl(const VectorGradient& gradient) { return gradient.by_x.y - gradient.by_y.x; }
/// How much a streamline of unit vectors turns left per length, `along` being its direction there, of length 1.
constexpr double streamline_curvature(const VectorGradient& gradient, Complex along) {
    return cross(along, along.x * gradient.by_x + along.y * gradient.by_y);
}

/// Of the field's values z themselves, as a tensor's traceless part changes.
VectorGradient value_gradient(const FieldOnSurface& field, SurfacePoint p);
/// Of the field's number (scalar_at), in the frame of p's face.
Complex scalar_gradient(const FieldOnSurface& field, SurfacePoint p);

}  // namespace rinceau
