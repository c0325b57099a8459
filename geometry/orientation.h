#pragma once
// Exact answers about points and segments: what the signs say of the coordinates as they are stored, without rounding.

#include <cmath>

#include "geometry/point.h"

namespace rinceau {

/// The sign of orientation(), by exact arithmetic.
int exact_orientation(Point a, Point b, Point c);

/// On which side of the line from a to b does c lie: 1 left, -1 right, 0 on the line. Exact while products of coordinates
/// neither overflow nor lose digits by underflow (sizes between 1e-100 and 1e100, or zero).
inline int orientation(Point a, Point b, Point c) {
    const double left = (a.x - c.x) * (b.y - c.y);
    const double right = (a.y - c.y) * (b.x - c.x);
    const double turn = left - right;
    // The largest error of `turn` is (3 + 16 e) e (|left| + |right|), e = 2^-53 (Shewchuk 1997, "A" of orient2d).
    constexpr double error_share = 3.3306690738754716e-16;
    const double bound = error_share * (std::abs(left) + std::abs(right));
    if (turn > bound) return 1;
    if (-turn > bound) return -1;
    return exact_orientation(a, b, c);
}

/// How two closed segments lie to each other; each may be a single point. crossed: each has its ends on both sides of the
/// other. Exact.
enum class SegmentContact : unsigned char { apart, touching, crossed };
SegmentContact segment_contact(Point a, Point b, Point c, Point d);

/// Have the closed segments a b and c d a point in common? Exact; either may be a single point.
inline bool segments_meet(Point a, Point b, Point c, Point d) {
    return segment_contact(a, b, c, d) != SegmentContact::apart;
}

/// Does the edge a b cross the ray from p, which does not lie on the edge, to the right? Half-open, so that a corner level
/// with p counts once: p lies inside a polygon (even-odd) if an odd number of its edges crosses. Exact.
inline bool crosses_ray(Point a, Point b, Point p) {
    if ((a.y <= p.y) == (b.y <= p.y)) return false;
    return (orientation(a, b, p) > 0) == (a.y <= p.y);
}

}  // namespace rinceau
