#pragma once
// What stands in an arrangement, as figures of the drawing that its exemplar was made of.

#include <vector>

#include "growth/arrangement/arrange_options.h"
#include "growth/figures.h"

namespace rinceau {

/// The figures that the references copy, where the elements stand, in the order given.
std::vector<PlacedFigure> placed_figures(const FiguredDrawing& drawing, const std::vector<ArrangedElement>& elements);

/// What a placed figure paints, in the scene.
Region placed_outline(const FiguredDrawing& drawing, const PlacedFigure& placed);

}  // namespace rinceau
