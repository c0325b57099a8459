#pragma once
// A picture of who is whose neighbour in an arrangement.

#include <string>
#include <utility>
#include <vector>

#include "growth/figures.h"

namespace rinceau {

/// What is placed in grey, edges between indices into it above, dots for elements.
std::string edges_svg(const FiguredDrawing& drawing, const std::vector<PlacedFigure>& placed,
                      const std::vector<std::pair<int, int>>& edges, const Box& canvas);

}  // namespace rinceau
