#pragma once
// What an element paints, at the points of a grid.

#include <optional>
#include <vector>

#include "analyzer/paint_color.h"
#include "analyzer/painted_outline.h"

namespace rinceau {

/// An element made ready to be sampled. It refers to the element's gradients and must not outlive it.
struct PaintedElement {
    PaintedOutline outline;
    PaintSampler fill;
    PaintSampler stroke;
    bool strokes = false;
    bool dashed = false;
    bool stroke_first = false;
    double opacity = 1;
};

/// Curves become polylines within `deviation`. `element` must paint something and not be verbatim.
PaintedElement painted_element(const Element& element, double deviation);

/// The points origin + step (column, row), row by row from below.
struct SampleGrid {
    Point origin;
    double step = 1;
    int columns = 0;
    int rows = 0;
};

/// The ink of `element` at every point of the grid, ends and bends of its stroke taken as round, mitres and square caps
/// painted. A stroke narrower than a step is a step wide and paints as much less strongly. `stroked` = false leaves it out.
std::vector<Ink> painted_samples(const PaintedElement& element, const SampleGrid& grid, bool stroked = true);

/// The ink that all of the box has, if the element has no edge there and no gradient.
std::optional<Ink> uniform_ink(const PaintedElement& element, const Box& box);

}  // namespace rinceau
