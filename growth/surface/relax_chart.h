#pragma once
// A patch laid flat with less stretch.

#include <vector>

#include "growth/surface/surface_chart.h"
#include "growth/surface/surface_field.h"

namespace rinceau {

/// The triangles moved so that they are as rigid as the surface allows ("as rigid as possible", Liu et al. 2008, "A
/// local/global approach to mesh parameterization"): the stretch of polar coordinates, which grows outwards, is shared out.
/// The origin stays on its place of the surface and keeps its direction of x there. Each vertex has one place in the chart.
/// `rounds` of local and global steps. The patch as it is if it has no area.
std::vector<ChartTriangle> relaxed_chart(const SurfaceMesh& surface, std::vector<ChartTriangle> triangles, int rounds);

/// A relaxed chart bent along a field: in the result the field has everywhere the angle to the chart's axes that it has at
/// the origin, as far as a map without cuts can do that; `follow` in [0, 1] of that turning. The chart as it is if it has no
/// area or the field is 0 at the origin. Round a singular point of the field the result is stretched or folds.
std::vector<ChartTriangle> bent_chart(const FieldOnSurface& field, double follow, std::vector<ChartTriangle> triangles);

}  // namespace rinceau
