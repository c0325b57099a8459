#pragma once
// Drawings that are made to be repeated side by side: what one edge cuts goes on at the opposite one.

#include <optional>

#include "growth/figures.h"

namespace rinceau {

/// The canvas, if the drawing is evidently a tile: at least two elements reach over its edge, and nearly all of those have a
/// twin at the opposite edge, a canvas further. Nothing if that is not so or no element reaches over an edge.
std::optional<Box> evident_tile(const FiguredDrawing& drawing);

/// The drawing with each element once: of twins that are a tile apart the one whose middle lies in the tile stays and is
/// whole; elements whose middle lies outside and that have no twin are moved in. What is kept as SVG text has no twins.
FiguredDrawing as_tile(FiguredDrawing drawing, const Box& tile);

}  // namespace rinceau
