#include "exports/cut_holes.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/polygon.h"

namespace rinceau {

namespace {

using Ring = std::vector<Point>;

struct PlacedRing {
    Ring corners;
    int parent = -1;  ///< the smallest ring around it
    int winding = 0;  ///< of the area inside it, by all rings around it and its own
    bool filled = false;
};

constexpr bool fills(FillRule rule, int winding, int depth) {
    return rule == FillRule::evenodd ? depth % 2 != 0 : winding != 0;
}

Ring ring_of(const Path& path, double deviation) {
    Ring corners = flattened(path, deviation);
    while (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
    return corners;
}

/// Parents, windings and what is filled, by the number of rings around each.
void place_rings(std::vector<PlacedRing>& rings, FillRule rule) {
    for (std::size_t i = 0; i < rings.size(); ++i) {
        PlacedRing& ring = rings[i];
        const double own_area = std::abs(signed_area(ring.corners));
        double smallest = std::numeric_limits<double>::infinity();
        int depth = 1;
        ring.winding = signed_area(ring.corners) > 0 ? 1 : -1;
        for (std::size_t k = 0; k < rings.size(); ++k) {
            const double area = std::abs(signed_area(rings[k].corners));
            if (k == i || area < own_area || (area == own_area && k > i)) continue;
            if (!inside_evenodd(rings[k].corners, ring.corners.front())) continue;
            ++depth;
            ring.winding += signed_area(rings[k].corners) > 0 ? 1 : -1;
            if (area < smallest) {
                smallest = area;
                ring.parent = static_cast<int>(k);
            }
        }
        ring.filled = fills(rule, ring.winding, depth);
    }
}

bool crosses(const Ring& ring, Point a, Point b) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Point from = ring[i];
        const Point to = ring[(i + 1) % ring.size()];
        if (from == a || from == b || to == a || to == b) continue;
        if (segment_crossing(a, b, from, to)) return true;
    }
    return false;
}

/// The hole goes in at the shortest slit between corners that crosses neither.
void cut_in(Ring& outer, Ring hole) {
    // around the hole the other way, so that its area is taken off
    if ((signed_area(outer) > 0) == (signed_area(hole) > 0)) std::ranges::reverse(hole);
    struct Slit {
        double length;
        std::size_t outer;
        std::size_t hole;
    };
    std::vector<Slit> slits;
    for (std::size_t i = 0; i < outer.size(); ++i) {
        for (std::size_t k = 0; k < hole.size(); ++k) slits.push_back({abs(outer[i] - hole[k]), i, k});
    }
    std::ranges::sort(slits, [](const Slit& a, const Slit& b) {
        return a.length != b.length ? a.length < b.length : std::pair(a.outer, a.hole) < std::pair(b.outer, b.hole);
    });
    const auto free = std::ranges::find_if(slits, [&](const Slit& slit) {
        return !crosses(outer, outer[slit.outer], hole[slit.hole]) && !crosses(hole, outer[slit.outer], hole[slit.hole]);
    });
    const Slit slit = free == slits.end() ? slits.front() : *free;
    Ring inserted;
    for (std::size_t k = 0; k <= hole.size(); ++k) inserted.push_back(hole[(slit.hole + k) % hole.size()]);
    inserted.push_back(outer[slit.outer]);
    outer.insert(outer.begin() + static_cast<std::ptrdiff_t>(slit.outer) + 1, inserted.begin(), inserted.end());
}

}  // namespace

std::vector<std::vector<Point>> polygons_with_cut_holes(const std::vector<Path>& paths, FillRule rule, double deviation) {
    std::vector<PlacedRing> rings;
    for (const Path& path : paths) {
        Ring corners = ring_of(path, deviation);
        if (corners.size() > 2) rings.push_back({std::move(corners)});
    }
    place_rings(rings, rule);
    std::vector<Ring> outlines(rings.size());
    for (std::size_t i = 0; i < rings.size(); ++i) {
        const bool around = rings[i].parent >= 0 && rings[static_cast<std::size_t>(rings[i].parent)].filled;
        if (rings[i].filled && !around) outlines[i] = rings[i].corners;
    }
    for (const PlacedRing& ring : rings) {
        if (ring.filled) continue;
        // up to the ring whose inside is filled and whose outside is not
        int outer = ring.parent;
        while (outer >= 0 && outlines[static_cast<std::size_t>(outer)].empty())
            outer = rings[static_cast<std::size_t>(outer)].parent;
        const bool hole = ring.parent >= 0 && rings[static_cast<std::size_t>(ring.parent)].filled;
        if (hole && outer >= 0) cut_in(outlines[static_cast<std::size_t>(outer)], ring.corners);
    }
    std::erase_if(outlines, [](const Ring& ring) { return ring.empty(); });
    return outlines;
}

}  // namespace rinceau
