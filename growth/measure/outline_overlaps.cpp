// Boxes in a tree, then edges that meet or an outline inside the other; only what is left is intersected.

#include "growth/measure/outline_overlaps.h"

#include <algorithm>

#include "geometry/box_tree.h"
#include "geometry/orientation.h"
#include "geometry/polygon.h"

namespace rinceau {
namespace {

struct OutlineEdge {
    Point a, b;
    Box box;
};

/// Edges that reach into the box, by their low x.
std::vector<OutlineEdge> edges_in(const Region& region, const Box& box) {
    std::vector<OutlineEdge> edges;
    for (const auto& ring : region)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()];
            const Box around = including(including(Box{}, a), b);
            if (overlap(around, box)) edges.push_back({a, b, around});
        }
    std::sort(edges.begin(), edges.end(),
              [](const OutlineEdge& e, const OutlineEdge& f) { return e.box.low.x < f.box.low.x; });
    return edges;
}

bool outlines_meet(const Region& a, const Region& b, const Box& common) {
    const std::vector<OutlineEdge> of_a = edges_in(a, common), of_b = edges_in(b, common);
    double widest = 0;
    for (const OutlineEdge& e : of_b) widest = std::max(widest, width(e.box));
    for (const OutlineEdge& e : of_a) {
        auto f = std::lower_bound(of_b.begin(), of_b.end(), e.box.low.x - widest,
                                  [](const OutlineEdge& edge, double x) { return edge.box.low.x < x; });
        for (; f != of_b.end() && f->box.low.x <= e.box.high.x; ++f)
            if (overlap(e.box, f->box) && segments_meet(e.a, e.b, f->a, f->b)) return true;
    }
    return false;
}

bool inside(const Region& region, Point p) {
    bool odd = false;
    for (const auto& ring : region) odd = odd != inside_evenodd(ring, p);
    return odd;
}

bool any_ring_inside(const Region& inner, const Region& outer) {
    return std::any_of(inner.begin(), inner.end(),
                       [&](const auto& ring) { return !ring.empty() && inside(outer, ring.front()); });
}

bool share_area(const Region& a, const Region& b, double share) {
    const Box box_a = bounds(a), box_b = bounds(b);
    const Box common{{std::max(box_a.low.x, box_b.low.x), std::max(box_a.low.y, box_b.low.y)},
                     {std::min(box_a.high.x, box_b.high.x), std::min(box_a.high.y, box_b.high.y)}};
    if (is_empty(common)) return false;
    if (!outlines_meet(a, b, common) && !any_ring_inside(a, b) && !any_ring_inside(b, a)) return false;
    return area(intersection_of(a, b)) > share * std::min(area(a), area(b));
}

Box bounds(const PlacedOutline& placed) {
    Box box;
    for (const auto& ring : *placed.outline)
        for (const Point p : ring) box = including(box, apply(placed.pose, p));
    return box;
}

}  // namespace

Region placed_region(const Region& region, const Similarity& pose) {
    Region moved = region;
    for (auto& ring : moved)
        for (Point& p : ring) p = apply(pose, p);
    return moved;
}

std::vector<std::pair<int, int>> overlapping_pairs(std::span<const PlacedOutline> outlines, double share) {
    std::vector<Box> boxes;
    boxes.reserve(outlines.size());
    for (const PlacedOutline& placed : outlines) boxes.push_back(bounds(placed));
    const BoxTree tree(boxes);
    std::vector<std::pair<int, int>> pairs;
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        Region outline;
        tree.visit(boxes[i], [&](std::size_t j) {
            if (j <= i) return true;
            if (outline.empty()) outline = placed_region(*outlines[i].outline, outlines[i].pose);
            if (share_area(outline, placed_region(*outlines[j].outline, outlines[j].pose), share))
                pairs.emplace_back(static_cast<int>(i), static_cast<int>(j));
            return true;
        });
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

}  // namespace rinceau
