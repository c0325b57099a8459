#pragma once
// The part of the plane that an element paints, as edges with a thickness.

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
    /// Of a mitre, whose tip is `to`: the painted triangle is this times the distance from the tip wide to either side.
    double tip_slope = 0;
};

/// Outlines as polylines within a deviation of the curves. Strokes are solid whatever their dashes; a mitre and a square cap
/// are edges of their own, so that no painted point is left out.
struct PaintedOutline {
    Box box;
    bool solid = false;  ///< the inside of the outline is painted
    FillRule fill_rule = FillRule::nonzero;
    double stroke_radius = 0;
    std::vector<ThickEdge> edges;  ///< the first `outline_edges` close every sub-path if `solid`
    std::size_t outline_edges = 0;
    std::vector<Point> starts;  ///< one point of each sub-path
    BoxTree tree;               ///< over the edges with their radii, if they are many
};

/// `element` must paint something and not be verbatim.
PaintedOutline painted_outline(const Element& element, double deviation);

/// Up to this many edges trying each is faster than asking a tree.
constexpr std::size_t edges_without_tree = 24;

/// Calls visit(index) for all edges that, grown by their radius, may meet `box`, and perhaps for others, until it returns
/// false.
template <class Visit>
void visit_edges(const PaintedOutline& outline, const Box& box, Visit&& visit) {
    if (outline.edges.size() > edges_without_tree) {
        outline.tree.visit(box, visit);
    } else {
        for (std::size_t i = 0; i < outline.edges.size() && visit(i); ++i) {
        }
    }
}

/// Does the fill rule put the point inside? False if the inside is not painted.
bool fills_point(const PaintedOutline& outline, Point p);

/// Does any edge with its radius reach into the box? Never no if one does.
bool edges_reach(const PaintedOutline& outline, const Box& box);

/// Do the painted regions come within `margin` of each other? Their polylines count, so the answer is off by the deviation
/// at most.
bool paint_touches(const PaintedOutline& a, const PaintedOutline& b, double margin);

}  // namespace rinceau
