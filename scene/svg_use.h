#pragma once
// Elements that put others in their place: use, symbol, nested svg, switch.

#include "scene/svg_reader.h"

namespace rinceau {

/// Each of these draws without the effects (opacity, clip, ...) of the element itself. `use` moves its context by x and y.
void draw_use(SvgReader& reader, SvgContext& context);
void draw_nested_svg(SvgReader& reader, const SvgContext& context);
void draw_switch(SvgReader& reader, const SvgContext& context);

/// requiredExtensions, requiredFeatures and systemLanguage of an element: is it to be drawn? The language is English.
bool passes_conditions(const SvgNode& node);

}  // namespace rinceau
