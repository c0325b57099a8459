#pragma once
// A field to look at: its lines, evenly spaced, and its singular points (Li et al. 2010, figures 6 and 7).

#include "geometry/progress.h"
#include "growth/surface/surface_field.h"
#include "growth/surface/surface_pattern.h"
#include "scene/element.h"

namespace rinceau {

struct FieldPictureOptions {
    double spacing = 0.0125;  ///< between neighbouring lines, diagonals of the surface; above 0
    bool minor = false;       ///< also the lines across those of a tensor or a vector field
    bool points = true;       ///< also the singular points
};

/// As meshes on the surface: lines as tubes, an arrow in the middle of each line of a vector field, singular points as balls
/// of singular_color(). Throws InputError if the spacing is not above 0.
SurfacePattern field_pattern(const FieldOnSurface& field, const FieldPictureOptions& options = {},
                             const Progress& progress = {});

/// The pattern of a field of the plane, seen from above, over white; as large as the surface in its unit.
Scene field_scene(const SurfacePattern& pattern, const SurfaceMesh& surface);

/// By n times the index: the least positive one (wedges) yellow, the least negative one (trisectors) blue; up to a whole
/// turn red and violet; beyond dark.
Color singular_color(int n, int index);

}  // namespace rinceau
