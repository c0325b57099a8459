#pragma once
// On which side of a line a point lies, and whether segments meet: decided exactly for the coordinates as they are given.

#include "geometry/point.h"

namespace rinceau {

/// +1 if c lies to the left of the line from a to b, -1 to the right, 0 on it: the sign of (b - a) x (c - a) without any
/// rounding (Shewchuk 1997, "Adaptive precision floating-point arithmetic and fast robust geometric predicates").
/// Coordinates are 0 or between 1e-120 and 1e120 in size.
int orientation(Point a, Point b, Point c);

/// How two segments lie to each other. crossed: each has its ends on both sides of the other.
enum class SegmentContact : unsigned char { apart, touching, crossed };
/// Segments may be single points.
SegmentContact segment_contact(Point a1, Point a2, Point b1, Point b2);

inline bool segments_meet(Point a1, Point a2, Point b1, Point b2) {
    return segment_contact(a1, a2, b1, b2) != SegmentContact::apart;
}

}  // namespace rinceau
