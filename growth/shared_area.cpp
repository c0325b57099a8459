// Exact contact of edges and containment decide for nearly all pairs; the area is asked for only of those that meet.

#include "growth/shared_area.h"

#include <algorithm>

#include "geometry/orientation.h"
#include "geometry/polygon.h"

namespace rinceau {
namespace {

struct OutlinePiece {
    Point a, b;
};

/// The edges that come into the box.
std::vector<OutlinePiece> pieces_in(const Region& region, const Box& box) {
    std::vector<OutlinePiece> pieces;
    for (const std::vector<Point>& ring : region) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()];
            if (overlap(including(Box{a, a}, b), box)) pieces.push_back({a, b});
        }
    }
    return pieces;
}

bool holds(const Region& region, Point p) {
    bool inside = false;
    for (const std::vector<Point>& ring : region) inside ^= inside_evenodd(ring, p);
    return inside;
}

bool meet(const Region& a, const Region& b) {
    const Box of_a = bounds(a), of_b = bounds(b);
    if (!overlap(of_a, of_b)) return false;
    const std::vector<OutlinePiece> pieces = pieces_in(b, of_a);
    for (const OutlinePiece& p : pieces_in(a, of_b)) {
        for (const OutlinePiece& q : pieces) {
            if (segments_meet(p.a, p.b, q.a, q.b)) return true;
        }
    }
    const auto any_ring_in = [](const Region& rings, const Region& region) {
        return std::any_of(rings.begin(), rings.end(),
                           [&](const auto& ring) { return !ring.empty() && holds(region, ring.front()); });
    };
    return any_ring_in(a, b) || any_ring_in(b, a);
}

}  // namespace

bool share_area(const Region& a, const Region& b) {
    constexpr double touching = 1e-4;
    return meet(a, b) && area(intersection_of(a, b)) > touching * std::min(area(a), area(b));
}

}  // namespace rinceau
