#pragma once
// The outline of what a pen paints.

#include "editor/mesh/triangulate.h"
#include "scene/path.h"
#include "scene/style.h"

namespace rinceau {

/// Contours whose inside by the nonzero rule is the stroke; they may cross themselves and each other. Arguments as those of
/// tessellated(); all points must be finite.
Contours stroke_outline(const std::vector<Path>& paths, const Stroke& stroke, double stroke_scale, double deviation);

}  // namespace rinceau
