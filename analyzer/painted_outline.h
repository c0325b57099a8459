#pragma once
// The part of the plane that an element paints, for the question whether two elements touch.

#include <vector>

#include "geometry/box.h"
#include "geometry/box_tree.h"
#include "scene/element.h"

namespace rinceau {

/// A straight piece of an outline, painted (or bordered) within `radius` of it.
struct ThickEdge {
    Point from;
    Point to;
    double radius = 0;
};

/// Outlines as polylines within a deviation of the curves. Strokes are solid whatever their dashes; a mitre and a square cap
/// are edges of their own, so that no painted point is left out.
struct PaintedOutline {
    Box box;
    bool solid = false;  ///< the inside of the outline is painted
    FillRule fill_rule = FillRule::nonzero;
    std::vector<ThickEdge> edges;   ///< the first `outline_edges` close every sub-path if `solid`
    std::size_t outline_edges = 0;
    std::vector<Point> starts;      ///< one point of each sub-path
    BoxTree tree;                   ///< over the edges with their radii, if they are many
};

/// `element` must paint something and not be verbatim.
PaintedOutline painted_outline(const Element& element, double deviation);

/// Do the painted regions come within `margin` of each other? Their polylines count, so the answer is off by the deviation at most.
bool paint_touches(const PaintedOutline& a, const PaintedOutline& b, double margin);

}  // namespace rinceau
