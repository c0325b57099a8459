#pragma once
// Plain outlines that shapes are made of: in the square from (-0.5, -0.5) to (0.5, 0.5), pointing along x.

#include "scene/painted_region.h"

namespace rinceau {

/// All counter-clockwise. A circle of radius 0.5; a regular polygon in it.
std::vector<Point> round_outline(int corners);
std::vector<Point> star_outline(int points, double inner);  ///< inner: share of the radius
/// A square with rounded corners of that radius, `steps` edges each.
std::vector<Point> tile_outline(double radius, int steps);
/// Pointed at both ends, fullest before the middle; `steps` edges a side.
std::vector<Point> leaf_outline(int steps);
/// The shaft takes `shaft` of the height, the head `head` of the length.
std::vector<Point> arrow_outline(double shaft, double head);
/// A disc that a gap along x (lines = 1), or one along x and one along y (2), cuts into parts (Li et al. 2010, figure 11).
Region glyph_outline(int corners, int lines, double gap);

}  // namespace rinceau
