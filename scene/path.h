#pragma once
// Outlines: lines and cubic Bezier curves, nothing else (NORMAL_FORM.md).

#include <vector>

#include "geometry/affine.h"
#include "geometry/box.h"
#include "geometry/similarity.h"

namespace rinceau {

/// From the end of the previous segment to `to`; a straight line ignores both control points (they lie on its ends).
struct Segment {
    Point control1;
    Point control2;
    Point to;
    bool straight = true;

    friend constexpr bool operator==(const Segment&, const Segment&) = default;
};

/// One connected sub-path. A closed path has a straight closing line from its last point to `start`, of length 0 when
/// they coincide; the closing line is not listed in `segments`.
struct Path {
    Point start;
    std::vector<Segment> segments;
    bool closed = false;

    friend bool operator==(const Path&, const Path&) = default;
};

constexpr Segment line_to(Point to) { return {to, to, to, true}; }
constexpr Segment curve_to(Point control1, Point control2, Point to) { return {control1, control2, to, false}; }

Path transformed(const Path& path, const Affine& map);
std::vector<Path> transformed(const std::vector<Path>& paths, const Affine& map);
std::vector<Path> transformed(const std::vector<Path>& paths, const Similarity& map);

/// The exact box of the curves themselves (extrema of cubics, not control points, no stroke); empty for no paths.
Box bounds(const std::vector<Path>& paths);

/// Arc length, closing lines of closed paths included; relative accuracy 1e-9.
double length(const std::vector<Path>& paths);

/// The path as a polyline whose distance from the curve is at most `deviation` (> 0); first point = start; a closed
/// path's polyline does not repeat its first point.
std::vector<Point> flattened(const Path& path, double deviation);

}  // namespace rinceau
