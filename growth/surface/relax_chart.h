#pragma once
// A patch laid flat with less stretch.

#include <vector>

#include "growth/surface/surface_chart.h"

namespace rinceau {

/// The triangles moved so that they are as rigid as the surface allows ("as rigid as possible", Liu et al. 2008, "A
/// local/global approach to mesh parameterization"): the stretch of polar coordinates, which grows outwards, is shared out.
/// The origin stays on its place of the surface and keeps its direction of x there. Each vertex has one place in the chart.
/// `rounds` of local and global steps. The patch as it is if it has no area.
std::vector<ChartTriangle> relaxed_chart(const SurfaceMesh& surface, std::vector<ChartTriangle> triangles, int rounds);

}  // namespace rinceau
