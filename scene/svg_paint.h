#pragma once
// Paints: colours, gradients with all that they take over from each other, and what of them is beyond the normal form.

#include "geometry/box.h"
#include "scene/svg_reader.h"

namespace rinceau {

/// What a value of `fill` or `stroke` comes to on one shape.
struct SvgPaint {
    Paint paint = NoPaint{};   ///< in scene space
    double opacity = 1;        ///< of the colour itself
    bool unsupported = false;  ///< a pattern or the like: the shape has to be kept as it is
};

/// `box` is the shape's geometry in its user space (for gradients in units of the box).
SvgPaint resolve_paint(SvgReader& reader, const SvgContext& context, const ParsedPaint& paint, const Box& box);

}  // namespace rinceau
