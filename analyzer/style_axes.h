#pragma once
// Directions that a style has of its own: gradients and stretched pens see how their shape is turned.

#include <vector>

#include "scene/style.h"

namespace rinceau {

/// Angles (radians) that turn along when the style is turned; empty if every rotation and mirror image leaves the style
/// alone. A direction of an axis, which a half turn leaves alone, is given both ways. Only the first paint with a direction
/// speaks: fill, stroke, pen. Offsets under `tolerance` (unit lengths) count as none.
std::vector<double> style_axes(const Style& style, double tolerance);

}  // namespace rinceau
