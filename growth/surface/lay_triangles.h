#pragma once
// Flat triangles laid on a surface through a chart, cut at the edges of its faces.

#include <array>
#include <span>

#include "growth/surface/drawing_chart.h"

namespace rinceau {

/// A convex polygon in a face's frame, counter-clockwise: corners first .. first + count - 1.
struct LaidPiece {
    int face = 0;
    int first = 0;
    int count = 0;
};

/// What was laid of a shape. Its map is one to one wherever it was laid.
struct LaidPieces {
    std::vector<LaidPiece> pieces;
    std::vector<Point> corners;  ///< in the frames of their faces
};

enum class LayFault : unsigned char { none, outside, stretched, folded };

/// How a shape may lie in a chart.
struct LayLimits {
    double stretch = 1.5;
};

/// A shape's triangles in the chart's plane and what they come to.
struct LayingTriangles {
    std::span<const Point> points;
    std::span<const std::array<int, 3>> triangles;  ///< counter-clockwise
    double area = 0;                                ///< of all triangles
};

/// All of the shape or nothing: a triangle of the chart that it meets is flipped (folded) or stretched beyond the limit, a
/// part of it lies on no triangle (outside), or on two (folded).
LayFault lay_triangles(const SurfaceMesh& surface, const DrawingChart& chart, const LayingTriangles& shape,
                       const LayLimits& limits, ChartVisits& visits, LaidPieces& laid);

/// Lines in place of triangles: pieces of two corners, in the order along each line. Parts outside of the patch are missing.
void lay_lines(const SurfaceMesh& surface, const DrawingChart& chart, std::span<const std::array<Point, 2>> lines,
               ChartVisits& visits, LaidPieces& laid);

}  // namespace rinceau
