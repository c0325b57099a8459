#pragma once
// Clipping: clips that cut nothing are dropped, elements wholly outside are dropped, what is cut is kept verbatim.

#include "scene/svg_reader.h"

namespace rinceau {

/// Applies the clip-path of `context` to the elements from `first` on. False if the clip is of a sort that cannot be told
/// (text in it, a basic shape, ...): nothing has been done then.
bool apply_clip_path(SvgReader& reader, const SvgContext& context, std::size_t first);

/// A shape in scene space.
struct SvgClipShape {
    std::vector<Path> paths;
    FillRule rule = FillRule::nonzero;
};

/// Clips the elements from `first` on to what lies in any of the shapes.
void clip_to_shapes(SvgReader& reader, std::size_t first, std::vector<SvgClipShape> shapes, const SvgNode& owner);

/// The box of the element of `context`, which has drawn the elements from `first` on, in its user space (without strokes and
/// clips); nothing if it cannot be told.
std::optional<Box> object_box(SvgReader& reader, const SvgContext& context, std::size_t first);

/// Clips the elements from `first` on to a convex polygon given in the space that `map` takes to SVG px.
void clip_to_polygon(SvgReader& reader, std::size_t first, const Affine& map, const std::vector<Point>& corners,
                     const SvgNode& owner);

}  // namespace rinceau
