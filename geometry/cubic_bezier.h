#pragma once
// Cubic Bezier curves: points, parts, extent, arc length, polylines.

#include <utility>
#include <vector>

#include "geometry/box.h"
#include "geometry/point.h"

namespace rinceau {

/// The curve (1-t)^3 from + 3 (1-t)^2 t control1 + 3 (1-t) t^2 control2 + t^3 to, t in [0, 1].
struct CubicBezier {
    Point from;
    Point control1;
    Point control2;
    Point to;

    friend constexpr bool operator==(const CubicBezier&, const CubicBezier&) = default;
};

Point evaluate(const CubicBezier& curve, double t);
/// d/dt of the curve.
Point derivative(const CubicBezier& curve, double t);
/// The parts before and after `t`.
std::pair<CubicBezier, CubicBezier> split(const CubicBezier& curve, double t);
/// The exact box of the curve (its extrema, not its control points).
Box bounds(const CubicBezier& curve);
/// Arc length, relative accuracy 1e-9 (absolute 1e-12 of the control polygon's length).
double arc_length(const CubicBezier& curve);
/// A polyline on the curve whose distance from it is at most `deviation` (> 0), without `from`, ending in `to`;
/// at most 4096 points.
std::vector<Point> flattened(const CubicBezier& curve, double deviation);

/// A point of a quadrature rule of the arc-length measure: the integral of g along the curve is the sum of weight * g(at).
struct ArcSample {
    Point at;
    double weight = 0;
};
/// Gauss-Legendre rule of `pieces` (>= 1) equal parameter intervals with 8 points each, in the order of t.
std::vector<ArcSample> arc_samples(const CubicBezier& curve, int pieces);

}  // namespace rinceau
