#pragma once
// Smoother fields with fewer singular points (Li et al. 2010, section 4.2 and figure 7).

#include <vector>

#include "geometry/progress.h"
#include "growth/surface/surface_field.h"

namespace rinceau {

/// Diffuses the field, its isotropic part and its numbers over about `radius` diagonals of the surface, in one implicit
/// step: features smaller than that vanish, the rest stays. A radius of 0 changes nothing; at 1 little but the smoothest
/// field is left. A closed form becomes values at vertices. Throws InputError as FieldOnSurface does, or if the radius is
/// negative or not finite.
SurfaceField smoothed(const SurfaceMesh& surface, SurfaceField field, double radius, const Progress& progress = {});

inline constexpr int most_smoothing_rounds = 100'000;

/// The paper's way: `rounds` times every vertex moves half-way to the mean of its neighbours. With `only` the vertices of a
/// region alone, all others stay.
SurfaceField smoothed_by_rounds(const SurfaceMesh& surface, SurfaceField field, int rounds,
                                const std::vector<int>& only = {}, const Progress& progress = {});

/// The field that turns least over the whole surface, up to a turn of the whole; mean strength 1.
SurfaceField smoothest_field(const SurfaceMesh& surface, int n, const Progress& progress = {});

/// The vertices within `radius` (in the surface's unit, along the surface) of a vertex.
std::vector<int> vertices_around(const SurfaceMesh& surface, int vertex, double radius);

}  // namespace rinceau
