#pragma once
// Do the outlines of two placed elements overlap?

#include <optional>

#include "growth/arrangement/growth_ground.h"

namespace rinceau {

/// An element of the exemplar somewhere.
struct PlacedReference {
    int reference = 0;
    Point position;
    double angle = 0;
};

inline PlacedReference placed_reference(const ArrangementNode& node) { return {node.reference, node.position, node.angle}; }

/// Do they share area? What only touches does not: less than 5e-5 of the smaller area does not count.
bool outlines_overlap(const GrowthGround& ground, const PlacedReference& a, const PlacedReference& b);

/// The elements whose outlines overlap that of `placed`, but for the node `except`; sorted.
std::vector<int> overlapped_elements(const ElementArrangement& arrangement, const GrowthGround& ground,
                                     const PlacedReference& placed, int except);

/// The direction that parts two positions, from the first to the second; if they are the same, any.
Point parting_way(Point from, Point to);

/// How much farther apart along the line of their positions two elements that overlap must be, so that they clearly do not.
double parting_distance(const GrowthGround& ground, const PlacedReference& a, const PlacedReference& b);

/// Where the outline is clear of all others, next to where it is placed; nothing if it would have to be moved by more than a
/// third of an edge. Where outlines may overlap (all modes but along a flow, where nothing can be moved later): as placed.
std::optional<Point> free_position(const ElementArrangement& arrangement, const GrowthGround& ground,
                                   const PlacedReference& placed, int except);

/// How far the outline of an element reaches from its position in a direction (of length 1).
double outline_extent(const ExemplarElement& element, double angle, Point direction);

}  // namespace rinceau
