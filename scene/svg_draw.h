#pragma once
// The walk over the tree: every element becomes elements of the scene, in paint order.

#include "scene/svg_reader.h"

namespace rinceau {

/// Draws a node of any kind below `parent`, with all its effects.
void draw_node(SvgReader& reader, const SvgContext& parent, const SvgNode& node);

/// Draws the children of an element, without effects of its own.
void draw_children(SvgReader& reader, const SvgContext& context);

/// Draws the root element; sets the scene's viewport.
void draw_root(SvgReader& reader);

}  // namespace rinceau
