#pragma once
// Polygons given by their corners in order, the last joined to the first; straight segments.

#include <optional>
#include <span>

#include "geometry/point.h"

namespace rinceau {

/// Area enclosed, positive if the corners run counter-clockwise (y up); regions wound twice count twice.
double signed_area(std::span<const Point> polygon);

/// How many times the polygon winds counter-clockwise about `p`. On an edge, one of the two values beside that edge.
int winding_number(std::span<const Point> polygon, Point p);
/// Is `p` inside by the even-odd rule? On an edge, either answer.
bool inside_evenodd(std::span<const Point> polygon, Point p);

/// The shortest distance from `p` to the segment from `a` to `b` (which may be a single point).
double distance_to_segment(Point p, Point a, Point b);

/// Where two segments meet: a1 + along_a (a2 - a1) = b1 + along_b (b2 - b1), both shares in [0, 1].
struct SegmentCrossing {
    Point at;
    double along_a = 0;
    double along_b = 0;
};
/// The single common point of two segments that are not parallel, if any; parallel segments give nothing.
std::optional<SegmentCrossing> segment_crossing(Point a1, Point a2, Point b1, Point b2);

}  // namespace rinceau
