#pragma once
// Polygons of any size that may cross themselves as triangles.

#include "editor/mesh/sweep.h"

namespace rinceau {

/// As swept_triangles, in time that grows little faster than the number of corners: large contours are cut into parts.
Triangles triangulated(const Contours& contours, FillRule rule);

}  // namespace rinceau
