#pragma once
// The curvature of a surface as a tensor field (Li et al. 2010, section 5.1).

#include "growth/surface/surface_field.h"

namespace rinceau {

/// The curvature tensor at every vertex: principal curvatures isotropic +- abs(value), positive where the surface bulges
/// outwards, the direction being that of the larger one. Their mean is isotropic, the Gaussian curvature
/// isotropic^2 - abs(value)^2. In 1 / (the surface's unit).
SurfaceField curvature_field(const SurfaceMesh& surface);

/// The same for guiding walks: where both curvatures are nearly equal (flats, spheres) the direction is noise and weakened:
/// by |z| / (|z| + 0.05 / diagonal).
SurfaceField guiding_curvature_field(const SurfaceMesh& surface);

}  // namespace rinceau
