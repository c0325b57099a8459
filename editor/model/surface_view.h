#pragma once
// What of growth on a surface is seen on the canvas and in the panel.

#include <optional>

#include "editor/model/editor_state.h"

namespace rinceau {

/// Is the surface on the canvas, in the document's place?
bool shows_surface(const EditorState& state);

/// The mark nearest to a window point, within reach pixels, of those that are seen.
std::optional<HeldMark> mark_near(const SurfaceState& surface, Point at, double reach);

const SurfaceMark& mark_of(const SurfaceSettings& settings, const HeldMark& which);

}  // namespace rinceau
