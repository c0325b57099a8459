#pragma once
// Growth under a round brush that is led along a path (Ijiri et al. 2008, section 5.1: spray tool).

#include <vector>

#include "growth/arrangement/grow_arrangement.h"
#include "growth/strokes.h"

namespace rinceau {

/// Where the brush stops on its way: at the ends of each line and between them at equal distances of at most half a radius.
std::vector<Brush> brush_stops(const std::vector<Polyline>& path, double radius);

/// What the brush covers on its way.
Region sprayed_region(const std::vector<Polyline>& path, double radius);

/// Grows under one stop after the other, from a seed in the middle of each where nothing stands yet. `order` as in grow();
/// its own brush plays no part.
ElementArrangement sprayed(ElementArrangement arrangement, const Exemplar& exemplar, const ArrangeSurroundings& around,
                           const std::vector<Brush>& stops, const GrowOrder& order, const Progress& progress = {});

}  // namespace rinceau
