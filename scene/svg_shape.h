#pragma once
// A shape element becomes elements of the scene: outline, style in its own frame, markers.

#include "scene/svg_reader.h"

namespace rinceau {

/// The style's lengths and pen in the image frame of `map` (user space to scene space; invertible), as the scene wants them:
/// an even map scales the width; any other leaves a pen of determinant 1 that is symmetric, so that equal looks have equal
/// numbers. A stroke that does not scale has its width in px: `pixel` is one in the unit of the scene.
Stroke stroke_under(const SvgStyle& style, const Affine& map, double pixel);

/// Draws the shape without the effects (opacity, clip, mask, filter) of its element.
void draw_shape(SvgReader& reader, const SvgContext& context);

}  // namespace rinceau
