#pragma once
// Elliptical arcs as cubic curves (SVG 1.1, appendix F.6).

#include <vector>

#include "scene/path.h"

namespace rinceau {

/// The arc command "A rx ry rotation large sweep to" from `from`; `rotation` in radians, y down. One cubic for each quarter
/// or less (radial error at most 2.8e-4 of the radius). Radii too small are scaled up, a zero radius gives a line,
/// coinciding ends a line of length 0.
std::vector<Segment> arc_segments(Point from, Point radii, double rotation, bool large, bool sweep, Point to);

/// Distance of a cubic's control points from its ends that makes it an arc of this angle (radians) of the unit circle.
double arc_handle(double angle);

}  // namespace rinceau
