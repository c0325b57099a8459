#pragma once
// Filled outlines with holes as single polygons. Internal to the folder.

#include <vector>

#include "scene/path.h"
#include "scene/style.h"

namespace rinceau {

/// Polygons that, filled one by one, cover what `paths` enclose by the rule, if the outlines do not cross each other: every
/// hole is joined to the outline around it by a slit from corner to corner. Curves within `deviation`; the first point is
/// not repeated. Outlines that cross are given as they are.
std::vector<std::vector<Point>> polygons_with_cut_holes(const std::vector<Path>& paths, FillRule rule, double deviation);

}  // namespace rinceau
