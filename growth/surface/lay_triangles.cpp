// Sutherland and Hodgman's cutting of a convex polygon by the sides of another. Both neighbours of a chart's edge see the
// same signed distances to it, so that what they keep meets without gap.

#include "growth/surface/lay_triangles.h"

#include <algorithm>
#include <cmath>

#include "geometry/box.h"
#include "geometry/index.h"

namespace rinceau {
namespace {

/// A triangle cut by three lines has six corners at most.
constexpr int most_corners = 9;
struct SmallPolygon {
    std::array<Point, most_corners> corner;
    int count = 0;
    void add(Point p) {
        if (count < most_corners) corner[at(count++)] = p;
    }
};

bool less(Point a, Point b) { return a.x != b.x ? a.x < b.x : a.y < b.y; }

/// Positive left of the line from a to b; the same number with the other sign for the line from b to a.
double side(Point a, Point b, Point p) { return less(a, b) ? cross(b - a, p - a) : -cross(a - b, p - b); }

/// The same point whichever end comes first.
Point between(Point p, double p_side, Point q, double q_side) {
    if (less(q, p)) {
        std::swap(p, q);
        std::swap(p_side, q_side);
    }
    return p + (p_side / (p_side - q_side)) * (q - p);
}

SmallPolygon cut_by(const SmallPolygon& polygon, Point a, Point b) {
    std::array<double, most_corners> sides;
    int inside = 0;
    for (int k = 0; k < polygon.count; ++k) {
        sides[at(k)] = side(a, b, polygon.corner[at(k)]);
        inside += sides[at(k)] >= 0 ? 1 : 0;
    }
    if (inside == polygon.count) return polygon;
    SmallPolygon kept;
    if (inside == 0) return kept;
    for (int k = 0; k < polygon.count; ++k) {
        const int next = k + 1 == polygon.count ? 0 : k + 1;
        const Point p = polygon.corner[at(k)], q = polygon.corner[at(next)];
        const double p_side = sides[at(k)], q_side = sides[at(next)];
        if (p_side >= 0) kept.add(p);
        if ((p_side > 0 && q_side < 0) || (p_side < 0 && q_side > 0)) kept.add(between(p, p_side, q, q_side));
    }
    return kept;
}

double area_of(const SmallPolygon& polygon) {
    double doubled = 0;
    for (int k = 1; k + 1 < polygon.count; ++k)
        doubled += cross(polygon.corner[at(k)] - polygon.corner[0], polygon.corner[at(k + 1)] - polygon.corner[0]);
    return 0.5 * doubled;
}

/// From the chart's plane to the face's frame.
struct ToFace {
    Point origin, x, y, face_origin;
    Point operator()(Point p) const {
        const Point d = p - origin;
        return face_origin + d.x * x + d.y * y;
    }
};
ToFace to_face(const SurfaceMesh& surface, const ChartTriangle& triangle) {
    const auto& flat = surface.flat[at(triangle.face)];
    const Point u = triangle.at[1] - triangle.at[0], v = triangle.at[2] - triangle.at[0];
    const Point a = flat[1] - flat[0], b = flat[2] - flat[0];
    const double area = cross(u, v);
    return {triangle.at[0], (v.y * a - u.y * b) / area, (u.x * b - v.x * a) / area, flat[0]};
}

void add_piece(LaidPieces& laid, int face, const SmallPolygon& polygon, const ToFace& map) {
    const int first = static_cast<int>(laid.corners.size());
    for (int k = 0; k < polygon.count; ++k) {
        const Point p = polygon.corner[at(k)];
        if (k > 0 && p == polygon.corner[at(k - 1)]) continue;
        if (k + 1 == polygon.count && k > 0 && p == polygon.corner[0]) continue;
        laid.corners.push_back(map(p));
    }
    const int count = static_cast<int>(laid.corners.size()) - first;
    if (count >= 3) {
        laid.pieces.push_back({face, first, count});
    } else {
        laid.corners.resize(at(first));
    }
}

Box box_of(const std::array<Point, 3>& corners) {
    Box box;
    for (const Point p : corners) box = including(box, p);
    return box;
}

}  // namespace

LayFault lay_triangles(const SurfaceMesh& surface, const DrawingChart& chart, const LayingTriangles& shape,
                       const LayLimits& limits, ChartVisits& visits, LaidPieces& laid) {
    // What rounding leaves of areas that should be the same or none.
    const double unseen = 1e-13 * shape.area, rounding = 1e-10 * shape.area;
    const std::size_t pieces_before = laid.pieces.size(), corners_before = laid.corners.size();
    double covered = 0;
    LayFault fault = LayFault::none;
    for (const auto& [i, j, k] : shape.triangles) {
        const std::array<Point, 3> corners{shape.points[at(i)], shape.points[at(j)], shape.points[at(k)]};
        const Box box = box_of(corners);
        visit_chart(chart, box, visits, [&](int t) {
            if (fault != LayFault::none) return;
            const ChartTriangle& triangle = chart.triangles[at(t)];
            const auto& q = triangle.at;
            if (!overlap(box, box_of(q))) return;
            const bool flipped = !(cross(q[1] - q[0], q[2] - q[0]) > 0);
            SmallPolygon polygon{{corners[0], corners[1], corners[2]}, 3};
            for (std::size_t e = 0; e < 3 && polygon.count >= 3; ++e) {
                const Point a = q[e], b = q[e == 2 ? 0 : e + 1];
                polygon = flipped ? cut_by(polygon, b, a) : cut_by(polygon, a, b);
            }
            if (polygon.count < 3) return;
            const double area = area_of(polygon);
            if (!(area > unseen)) return;
            covered += area;
            if (flipped) fault = LayFault::folded;
            if (!flipped && chart.stretch[at(t)] > limits.stretch) fault = LayFault::stretched;
            if (fault == LayFault::none) add_piece(laid, triangle.face, polygon, to_face(surface, triangle));
        });
        if (fault != LayFault::none) break;
    }
    if (fault == LayFault::none && covered < shape.area - rounding) fault = LayFault::outside;
    if (fault == LayFault::none && covered > shape.area + rounding) fault = LayFault::folded;
    if (fault != LayFault::none) {
        laid.pieces.resize(pieces_before);
        laid.corners.resize(corners_before);
    }
    return fault;
}

void lay_lines(const SurfaceMesh& surface, const DrawingChart& chart, std::span<const std::array<Point, 2>> lines,
               ChartVisits& visits, LaidPieces& laid) {
    for (const std::array<Point, 2>& line : lines) {
        const Point start = line[0], end = line[1];  // clang 14 does not capture structured bindings
        Box box;
        box = including(including(box, start), end);
        visit_chart(chart, box, visits, [&](int t) {
            const ChartTriangle& triangle = chart.triangles[at(t)];
            const auto& q = triangle.at;
            if (!overlap(box, box_of(q)) || !(cross(q[1] - q[0], q[2] - q[0]) > 0)) return;
            double from = 0, to = 1;
            for (std::size_t e = 0; e < 3; ++e) {
                const double s = side(q[e], q[e == 2 ? 0 : e + 1], start), f = side(q[e], q[e == 2 ? 0 : e + 1], end);
                if (s < 0 && f <= 0) to = -1;
                if (s < 0 && f > 0) from = std::max(from, s / (s - f));
                if (s > 0 && f < 0) to = std::min(to, s / (s - f));
            }
            if (!(from < to)) return;
            const ToFace map = to_face(surface, triangle);
            laid.pieces.push_back({triangle.face, static_cast<int>(laid.corners.size()), 2});
            laid.corners.push_back(map(start + from * (end - start)));
            laid.corners.push_back(map(start + to * (end - start)));
        });
    }
}

}  // namespace rinceau
