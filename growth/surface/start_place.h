#pragma once
// Where to begin a drawing if nobody has said it.

#include "growth/surface/drawing_chart.h"
#include "growth/surface/surface_field.h"

namespace rinceau {

/// A place about which a disc of `radius` (surface length; more than a fifth of the diagonal counts as that) lies as flat as
/// possible, clear of borders and turned one way, of several spread over the surface; outside rather than in a hole, and of
/// equals rather one that is seen from the front and above.
SurfacePoint start_place(const SurfaceMesh& surface, double radius);

/// The direction (length 1, in the frame of the place's face) of a drawing's up there: that of the y axis of space, or where
/// that is nearly the normal, away from the z axis; with a field, of its directions the one nearest to that.
Complex start_up(const SurfaceMesh& surface, const FieldOnSurface* field, SurfacePoint place);

}  // namespace rinceau
