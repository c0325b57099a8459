#pragma once
// Markers: arrow heads and the like at the vertices of a path (SVG 2, chapter 13.7).

#include <vector>

#include "scene/path.h"
#include "scene/svg_reader.h"

namespace rinceau {

inline bool has_markers(const SvgStyle& style) {
    return !style.marker_start.empty() || !style.marker_mid.empty() || !style.marker_end.empty();
}

/// Draws the markers of a shape with this outline (user space, y down). `style` is what its fill and stroke came to.
void draw_markers(SvgReader& reader, const SvgContext& context, const std::vector<Path>& outline, const Style& style);

}  // namespace rinceau
