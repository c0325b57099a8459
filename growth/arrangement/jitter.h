#pragma once
// Random differences between elements that have been placed: angle, size and colour.

#include <cstdint>
#include <vector>

#include "growth/arrangement/boundary.h"
#include "growth/figures.h"

namespace rinceau {

struct JitterOptions {
    double angle = 0;  ///< largest turn to either side, radians, in [0, pi]
    double scale = 0;  ///< largest factor is 1 + scale, least 1 / (1 + scale); not negative
    double color = 0;  ///< in [0, 1]: hues turn by up to this share of half a circle, lightness changes by up to half of it
    std::uint64_t seed = 1;
};

/// The placed figures, each turned and scaled about its centre and with its solid paints in other colours, drawn evenly from
/// the ranges. Every element has a random stream of its own, in which angle, scale and colour come from numbers of their
/// own: whether one of them is asked for does not change the others. Where a figure would share area with another one that
/// it did not share area with before, or would be cut by the boundary, its turn and scale are halved until it does not.
/// Gradients and SVG text keep their colours.
std::vector<PlacedFigure> jittered(const FiguredDrawing& drawing, const std::vector<PlacedFigure>& placed,
                                   const JitterOptions& options, const Boundary* boundary = nullptr);

}  // namespace rinceau
