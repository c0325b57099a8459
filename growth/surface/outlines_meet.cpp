#include "growth/surface/outlines_meet.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "geometry/orientation.h"
#include "geometry/polygon.h"

namespace rinceau {
namespace {

constexpr int ellipse_corners = 48;     // the arc reaches .2 % of the radius over the chord
constexpr double touching_area = 1e-9;  // of the smaller box: shared area that does not count

std::vector<Point> rectangle(const CollisionBody& body) {
    const double x = body.half.x, y = body.half.y;
    return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

std::vector<Point> ellipse(const CollisionBody& body) {
    std::vector<Point> ring;
    for (int i = 0; i < ellipse_corners; ++i) {
        const Point p = polar(1, two_pi * i / ellipse_corners);
        ring.push_back({body.half.x * p.x, body.half.y * p.y});
    }
    return ring;
}

/// In the plane of axes 0 and 1 about the centre.
Region flat_outline(const CollisionBody& body) {
    if (body.collide == CollideAs::box) return {rectangle(body)};
    if (body.collide == CollideAs::disc) return {ellipse(body)};
    Region region = body.collide == CollideAs::hull ? Region{{body.hull.begin(), body.hull.end()}} : *body.outline;
    for (auto& ring : region)
        for (Point& p : ring) p = Point{p.x * body.outline_scale.x, p.y * body.outline_scale.y} + body.outline_shift;
    return region;
}

struct Edge {
    Point a, b;
    Box box;
};

std::vector<Edge> edges_in(const Region& region, const Box& box) {
    std::vector<Edge> edges;
    for (const auto& ring : region)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[i + 1 < ring.size() ? i + 1 : 0];
            const Box around = including(including(Box{}, a), b);
            if (overlap(around, box)) edges.push_back({a, b, around});
        }
    return edges;
}

bool any_edges_meet(const std::vector<Edge>& of_a, const std::vector<Edge>& of_b) {
    for (const Edge& e : of_a)
        for (const Edge& f : of_b)
            if (overlap(e.box, f.box) && segments_meet(e.a, e.b, f.a, f.b)) return true;
    return false;
}

double area_of(const Box& box) { return width(box) * height(box); }

bool any_ring_inside(const Region& inner, const Region& outer) {
    const auto inside = [&](Point p) {
        bool odd = false;
        for (const auto& ring : outer) odd = odd != inside_evenodd(ring, p);
        return odd;
    };
    return std::any_of(inner.begin(), inner.end(), [&](const auto& ring) { return !ring.empty() && inside(ring.front()); });
}

}  // namespace

Region outline_in_plane(const CollisionBody& body, double shrink, SpacePoint origin, SpacePoint x, SpacePoint y) {
    const SpacePoint to_centre = body.centre - origin;
    const Point centre{dot(to_centre, x), dot(to_centre, y)};
    const Point first = shrink * Point{dot(body.axes[0], x), dot(body.axes[0], y)};
    const Point second = shrink * Point{dot(body.axes[1], x), dot(body.axes[1], y)};
    Region region = flat_outline(body);
    for (auto& ring : region)
        for (Point& p : ring) p = centre + p.x * first + p.y * second;
    return region;
}

bool outlines_meet(const CollisionBody& a, const CollisionBody& b, double shrink_a, double shrink_b) {
    const double side = dot(a.axes[2], b.axes[2]) < 0 ? -1 : 1;
    const SpacePoint normal = unit(a.axes[2] + side * b.axes[2]);
    const SpacePoint x = unit(cross(a.axes[1], normal)), y = cross(normal, x);
    const Region first = outline_in_plane(a, shrink_a, a.centre, x, y);
    const Region second = outline_in_plane(b, shrink_b, a.centre, x, y);
    const Box box_a = bounds(first), box_b = bounds(second);
    const Box common{{std::max(box_a.low.x, box_b.low.x), std::max(box_a.low.y, box_b.low.y)},
                     {std::min(box_a.high.x, box_b.high.x), std::min(box_a.high.y, box_b.high.y)}};
    if (is_empty(common)) return false;
    if (any_edges_meet(edges_in(first, common), edges_in(second, common)))  // touching ones may cross by rounding
        return area(intersection_of(first, second)) > touching_area * std::min(area_of(box_a), area_of(box_b));
    return any_ring_inside(first, second) || any_ring_inside(second, first);
}

}  // namespace rinceau
