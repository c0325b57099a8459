#include "geometry/polygon.h"

#include <algorithm>

namespace rinceau {

namespace {

// +1 / -1 where the edge a -> b crosses the ray from p to the right upwards / downwards, else 0. Half-open in y, so that a
// corner on the ray counts once.
int ray_crossing(Point a, Point b, Point p) {
    if ((a.y <= p.y) == (b.y <= p.y)) return 0;
    const double side = cross(b - a, p - a);
    if (a.y <= p.y) return side > 0 ? 1 : 0;
    return side < 0 ? -1 : 0;
}

template <class Visit>
void for_each_edge(std::span<const Point> polygon, Visit visit) {
    for (std::size_t i = 0; i < polygon.size(); ++i) visit(polygon[i], polygon[i + 1 < polygon.size() ? i + 1 : 0]);
}

}  // namespace

double signed_area(std::span<const Point> polygon) {
    if (polygon.empty()) return 0;
    // About the first corner: a small polygon far from the origin keeps its digits.
    const Point origin = polygon.front();
    double doubled = 0;
    for_each_edge(polygon, [&](Point a, Point b) { doubled += cross(a - origin, b - origin); });
    return 0.5 * doubled;
}

int winding_number(std::span<const Point> polygon, Point p) {
    int winding = 0;
    for_each_edge(polygon, [&](Point a, Point b) { winding += ray_crossing(a, b, p); });
    return winding;
}

bool inside_evenodd(std::span<const Point> polygon, Point p) {
    bool inside = false;
    for_each_edge(polygon, [&](Point a, Point b) { inside ^= ray_crossing(a, b, p) != 0; });
    return inside;
}

double distance_to_segment(Point p, Point a, Point b) {
    const Point along = b - a;
    const double squared = norm(along);
    if (!(squared > 0)) return abs(p - a);
    return abs(p - (a + std::clamp(dot(p - a, along) / squared, 0.0, 1.0) * along));
}

std::optional<SegmentCrossing> segment_crossing(Point a1, Point a2, Point b1, Point b2) {
    const Point a = a2 - a1;
    const Point b = b2 - b1;
    const double turn = cross(a, b);
    if (turn == 0) return std::nullopt;
    const double along_a = cross(b1 - a1, b) / turn;
    const double along_b = cross(b1 - a1, a) / turn;
    if (!(along_a >= 0 && along_a <= 1 && along_b >= 0 && along_b <= 1)) return std::nullopt;
    return SegmentCrossing{a1 + along_a * a, along_a, along_b};
}

}  // namespace rinceau
