// Circles, boxes, then edges that meet or an outline inside the other; only what is left is intersected.
#include "growth/arrangement/outline_contact.h"

#include <algorithm>

#include "geometry/orientation.h"
#include "geometry/polygon.h"
#include "geometry/similarity.h"

namespace rinceau {

namespace {

constexpr double touching = 5e-5;  // of the smaller area
constexpr int bisections = 6;      // of the way that a pair is pushed apart
constexpr int free_rounds = 5;
constexpr double farthest_free = 1.0 / 3;  // mean edges
constexpr double clearance = 4e-3;         // mean edges between outlines that were pushed apart

Region placed_outline(const ExemplarElement& element, Point position, double angle) {
    Region placed = element.outline;
    const Complex turn = polar(1, angle);
    for (std::vector<Point>& ring : placed)
        for (Point& p : ring) p = position + turn * p;
    return placed;
}

// Holds the box of the turned outline.
Box turned_box(const Box& box, Point position, double angle) {
    if (is_empty(box)) return box;
    const Complex turn = polar(1, angle);
    const double half_width = 0.5 * (std::abs(turn.x) * width(box) + std::abs(turn.y) * height(box));
    const double half_height = 0.5 * (std::abs(turn.y) * width(box) + std::abs(turn.x) * height(box));
    const Point middle = position + turn * center(box);
    return {middle - Point{half_width, half_height}, middle + Point{half_width, half_height}};
}

/// An edge with its box.
struct BoxedEdge {
    Point a, b;
    Box box;
};

std::vector<BoxedEdge> edges_in(const Region& region, const Box& box) {
    std::vector<BoxedEdge> edges;
    for (const std::vector<Point>& ring : region) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i];
            const Point b = ring[i + 1 < ring.size() ? i + 1 : 0];
            const Box around = including(including(Box{}, a), b);
            if (overlap(around, box)) edges.push_back({a, b, around});
        }
    }
    return edges;
}

bool edges_meet(const Region& a, const Region& b, const Box& common) {
    const std::vector<BoxedEdge> of_a = edges_in(a, common);
    const std::vector<BoxedEdge> of_b = edges_in(b, common);
    for (const BoxedEdge& e : of_a)
        for (const BoxedEdge& f : of_b)
            if (overlap(e.box, f.box) && segments_meet(e.a, e.b, f.a, f.b)) return true;
    return false;
}

bool is_inside(const Region& region, Point p) {
    bool odd = false;
    for (const std::vector<Point>& ring : region) odd ^= inside_evenodd(ring, p);
    return odd;
}

bool any_ring_inside(const Region& inner, const Region& outer) {
    return std::any_of(inner.begin(), inner.end(),
                       [&](const std::vector<Point>& ring) { return !ring.empty() && is_inside(outer, ring.front()); });
}

}  // namespace

bool outlines_overlap(const GrowthGround& ground, const PlacedReference& a, const PlacedReference& b) {
    const ExemplarElement& of_a = ground.exemplar.elements[static_cast<std::size_t>(a.reference)];
    const ExemplarElement& of_b = ground.exemplar.elements[static_cast<std::size_t>(b.reference)];
    if (abs(b.position - a.position) >= of_a.radius + of_b.radius) return false;
    if (!overlap(turned_box(ground.boxes[static_cast<std::size_t>(a.reference)], {}, a.angle),
                 turned_box(ground.boxes[static_cast<std::size_t>(b.reference)], b.position - a.position, b.angle)))
        return false;
    // About the first one: far from the origin digits would be lost.
    const Region first = placed_outline(of_a, {}, a.angle);
    const Region second = placed_outline(of_b, b.position - a.position, b.angle);
    const Box box_a = bounds(first);
    const Box box_b = bounds(second);
    if (!overlap(box_a, box_b)) return false;
    const Box common{{std::max(box_a.low.x, box_b.low.x), std::max(box_a.low.y, box_b.low.y)},
                     {std::min(box_a.high.x, box_b.high.x), std::min(box_a.high.y, box_b.high.y)}};
    if (!edges_meet(first, second, common) && !any_ring_inside(first, second) && !any_ring_inside(second, first))
        return false;
    return area(intersection_of(first, second)) > touching * std::min(area(first), area(second));
}

std::vector<int> overlapped_elements(const ElementArrangement& arrangement, const GrowthGround& ground,
                                     const PlacedReference& placed, int except) {
    const double reach = ground.exemplar.elements[static_cast<std::size_t>(placed.reference)].radius + ground.largest_radius;
    std::vector<int> overlapped;
    arrangement.grid.visit(placed.position, reach, [&](int node, Point) {
        const ArrangementNode& other = arrangement.nodes[static_cast<std::size_t>(node)];
        if (node == except || !is_element(other)) return;
        if (outlines_overlap(ground, placed, placed_reference(other))) overlapped.push_back(node);
    });
    std::sort(overlapped.begin(), overlapped.end());
    return overlapped;
}

double outline_extent(const ExemplarElement& element, double angle, Point direction) {
    const Point own = conj(polar(1, angle)) * direction;
    double reach = 0;
    for (const std::vector<Point>& ring : element.outline)
        for (const Point p : ring) reach = std::max(reach, dot(p, own));
    return reach;
}

Point parting_way(Point from, Point to) {
    const double distance = abs(to - from);
    return distance > 0 ? (to - from) / distance : Point{1, 0};
}

double parting_distance(const GrowthGround& ground, const PlacedReference& a, const PlacedReference& b) {
    const auto& elements = ground.exemplar.elements;
    const Point way = parting_way(a.position, b.position);
    // Convex outlines are apart at the latest where their extents are.
    double enough = outline_extent(elements[static_cast<std::size_t>(a.reference)], a.angle, way) +
                    outline_extent(elements[static_cast<std::size_t>(b.reference)], b.angle, -way) -
                    abs(b.position - a.position);
    double too_little = 0;
    for (int i = 0; i < bisections; ++i) {
        const double middle = 0.5 * (too_little + enough);
        PlacedReference moved = b;
        moved.position += middle * way;
        (outlines_overlap(ground, a, moved) ? too_little : enough) = middle;
    }
    return enough + clearance * ground.exemplar.mean_edge;
}

std::optional<Point> free_position(const ElementArrangement& arrangement, const GrowthGround& ground,
                                   const PlacedReference& placed, int except) {
    if (!ground.exclusive) return placed.position;
    PlacedReference moved = placed;
    for (int round = 0; round < free_rounds; ++round) {
        const std::vector<int> others = overlapped_elements(arrangement, ground, moved, except);
        if (others.empty()) return moved.position;
        for (const int other : others) {
            const PlacedReference second = placed_reference(arrangement.nodes[static_cast<std::size_t>(other)]);
            if (!outlines_overlap(ground, second, moved)) continue;
            moved.position += parting_distance(ground, second, moved) * parting_way(second.position, moved.position);
        }
        if (abs(moved.position - placed.position) > farthest_free * ground.exemplar.mean_edge) return std::nullopt;
    }
    return std::nullopt;
}

}  // namespace rinceau
