#pragma once
// Drawings that are made to be repeated side by side: what one edge cuts goes on at the opposite one.

#include <optional>

#include "growth/arrangement/exemplar.h"
#include "growth/figures.h"

namespace rinceau {

/// The canvas, if the drawing is evidently a tile: at least two elements reach over its edge, and nearly all of those go on
/// at the opposite edge, by a copy a canvas further or by the piece that the edge has cut off. Nothing otherwise.
std::optional<Box> evident_tile(const FiguredDrawing& drawing);

/// The canvas, if the drawing is evidently a tile or could well be one: no element is cut, and laid side by side copies keep
/// the distances that elements keep in the drawing: no two of two kinds come much nearer to each other, no gap is wider.
std::optional<Box> likely_tile(const FiguredDrawing& drawing);

/// The tile that an exemplar is best made with: the evident one; or the likely one, if without it the exemplar is irregular
/// and has too few elements to choose from, or none.
std::optional<Box> sensible_tile(const FiguredDrawing& drawing, const ExemplarOptions& options = {});

/// The drawing with each element once: of copies that are a tile apart the one whose middle lies in the tile stays and is
/// whole; pieces that meet across the tile's edge become one element, of a figure of its own, which is whole if they overlap
/// so that no seam shows; middles are moved into the tile.
FiguredDrawing as_tile(const FiguredDrawing& drawing, const Box& tile);

}  // namespace rinceau
