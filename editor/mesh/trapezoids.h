#pragma once
// Insides of outlines that cross themselves again and again, as trapezoids with level sides.

#include "editor/mesh/sweep.h"

namespace rinceau {

/// Pairs of edges that cross each other properly, counted; estimated from a sample for many edges.
double crossing_count(const Contours& contours);

/// The inside of the contours by the rule as triangles that do not overlap. Time grows with the square of the edges, and
/// with the crossings times the edges: meant for few edges. All points must be finite.
Triangles trapezoid_triangles(const Contours& contours, FillRule rule);

/// Much like it, drawn with `rows` level rows of rectangles at most, in which gaps narrower than a row is high are closed.
/// Time grows with rows times edges.
Triangles row_triangles(const Contours& contours, FillRule rule, int rows);

}  // namespace rinceau
