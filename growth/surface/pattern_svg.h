#pragma once
// A pattern in the plane as a drawing.

#include <string>

#include "geometry/box.h"
#include "growth/surface/surface_pattern.h"

namespace rinceau {

/// What has grown in the plane z = 0, seen from above, as SVG: every shape's outline once and its copies as uses, from the
/// lowest to the highest and in the order of placing; lines as strokes; laid meshes as filled outlines. The canvas becomes
/// `width` pixels wide; its width and height are above 0.
std::string pattern_svg(const SurfacePattern& pattern, const Box& canvas, double width = 1000);

}  // namespace rinceau
