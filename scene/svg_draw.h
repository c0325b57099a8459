#pragma once
// The walk over the tree: every element becomes elements of the scene, in paint order.

#include <optional>

#include "scene/svg_reader.h"

namespace rinceau {

/// Draws a node of any kind below `parent`, with all its effects.
void draw_node(SvgReader& reader, const SvgContext& parent, const SvgNode& node);

/// Draws the children of an element, without effects of its own.
void draw_children(SvgReader& reader, const SvgContext& context);

/// Smaller than this share of the picture's diagonal, a difference does not show.
constexpr double invisible_share = 5e-5;

/// The context inside the root element; sets the scene's viewport, and what depends on it. Nothing if the root shows nothing.
std::optional<SvgContext> enter_root(SvgReader& reader);

/// Draws the root element; sets the scene's viewport.
void draw_root(SvgReader& reader);

/// An element of a kind that draws something in its place: shapes, containers, text, images.
bool is_drawn_kind(const SvgNode& node);
/// An element that other programs may draw, and this one leaves out: flowRoot, names that SVG does not know.
bool is_undrawn_content(const SvgNode& node);

}  // namespace rinceau
