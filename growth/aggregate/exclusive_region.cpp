// Sakurai & Miyata 2014, section 3.1. There a person draws the vertices and the region is triangulated; here the region is
// made from the outline: union -> closing (joins parts, fills slots that no neighbour could enter) -> margin -> one ring ->
// fewer corners. The overlap test works on the outline itself, so nothing is triangulated.

#include "growth/aggregate/exclusive_region.h"

#include <algorithm>
#include <cmath>

#include "geometry/orientation.h"
#include "geometry/polygon.h"
#include "growth/aggregate/inner_discs.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

using Ring = std::vector<Point>;

/// An outline with less than this share of its diagonal's square has no area.
constexpr double least_area_share = 1e-9;
/// The margin that simplification eats up, in multiples of its tolerance.
constexpr double simplification_margin = 4.0 / 3;
/// Part of the region's area by which an outline may stick out for the rounding of Clipper's grid.
constexpr double rounding_area_share = 1e-7;

std::size_t farthest_from(const Ring& ring, Point from) {
    std::size_t farthest = 0;
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (norm(ring[i] - from) > norm(ring[farthest] - from)) farthest = i;
    return farthest;
}

/// Douglas & Peucker 1973 on ring[first .. last]: marks the corners that stay.
void keep_corners(const Ring& ring, std::size_t first, std::size_t last, double tolerance, std::vector<bool>& kept) {
    std::vector<std::pair<std::size_t, std::size_t>> open{{first, last}};
    while (!open.empty()) {
        const auto [from, to] = open.back();
        open.pop_back();
        std::size_t farthest = from;
        double distance = tolerance;
        for (std::size_t i = from + 1; i < to; ++i) {
            const double d = distance_to_segment(ring[i], ring[from], ring[to % ring.size()]);
            if (d > distance) distance = d, farthest = i;
        }
        if (farthest == from) continue;
        kept[farthest] = true;
        open.emplace_back(from, farthest);
        open.emplace_back(farthest, to);
    }
}

Ring simplified(Ring ring, double tolerance) {
    // Begin at two corners far apart, which stay.
    std::rotate(ring.begin(), ring.begin() + static_cast<std::ptrdiff_t>(farthest_from(ring, ring.front())), ring.end());
    const std::size_t opposite = farthest_from(ring, ring.front());
    std::vector<bool> kept(ring.size(), false);
    kept.front() = kept[opposite] = true;
    keep_corners(ring, 0, opposite, tolerance, kept);
    keep_corners(ring, opposite, ring.size(), tolerance, kept);
    Ring result;
    for (std::size_t i = 0; i < ring.size(); ++i)
        if (kept[i]) result.push_back(ring[i]);
    return result;
}

Region simplified(const Region& region, double tolerance) {
    Region result;
    for (const Ring& ring : region)
        if (Ring few = simplified(ring, tolerance); few.size() >= 3) result.push_back(std::move(few));
    return result;
}

/// Do edges meet that are not neighbours in one ring?
bool is_simple(const Region& region) {
    struct RingEdge {
        Point a, b;
        std::size_t ring, index, count;
    };
    std::vector<RingEdge> edges;
    for (std::size_t r = 0; r < region.size(); ++r)
        for (std::size_t i = 0; i < region[r].size(); ++i)
            edges.push_back({region[r][i], region[r][(i + 1) % region[r].size()], r, i, region[r].size()});
    for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t k = i + 1; k < edges.size(); ++k) {
            const RingEdge &e = edges[i], &f = edges[k];
            const bool neighbors = e.ring == f.ring && (f.index == e.index + 1 || (e.index == 0 && f.index + 1 == f.count));
            if (!neighbors && segments_meet(e.a, e.b, f.a, f.b)) return false;
        }
    return true;
}

Ring convex_hull(const Region& region) {
    Ring points;
    for (const Ring& ring : region) points.insert(points.end(), ring.begin(), ring.end());
    std::ranges::sort(points, [](Point a, Point b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
    Ring hull;
    // Lower side, then upper side (Andrew 1979).
    for (int side = 0; side < 2; ++side, std::ranges::reverse(points)) {
        const std::size_t start = hull.size();
        for (const Point p : points) {
            while (hull.size() >= start + 2 && orientation(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();  // where the other side begins
    }
    return hull;
}

std::size_t count_parts(const Region& oriented) {
    return static_cast<std::size_t>(std::ranges::count_if(oriented, [](const Ring& ring) { return signed_area(ring) > 0; }));
}

/// Of an oriented region the largest outer ring, first, and its holes if they are kept.
Region largest_part(const Region& oriented, bool keep_holes, double least_hole) {
    const auto largest = std::ranges::max_element(oriented, {}, [](const Ring& ring) { return signed_area(ring); });
    if (largest == oriented.end() || signed_area(*largest) <= 0) return {};
    Region part{*largest};
    for (const Ring& ring : oriented)
        if (keep_holes && signed_area(ring) < -least_hole && inside_evenodd(part.front(), ring.front()))
            part.push_back(ring);
    return part;
}

/// One part that holds the outline: what closing does not join is held together by its convex hull.
Region joined(const Region& outline, double closing, const ExclusiveRegionOptions& options) {
    // Offsetting by nothing orients the rings.
    Region closed = closing > 0 ? offset_region(offset_region(outline, closing), -closing) : offset_region(outline, 0);
    if (count_parts(closed) > 1) return {convex_hull(outline)};
    return largest_part(closed, options.keep_holes, closing * closing);
}

/// Fewer corners, rings still simple and apart, and the outline still inside where `outline` is given.
Region with_few_corners(const Region& region, const Region* outline, double tolerance) {
    const double spare = rounding_area_share * area(region);
    for (int attempt = 0; attempt < 6; ++attempt, tolerance /= 2) {
        Region few = simplified(region, tolerance);
        if (few.empty() || signed_area(few.front()) <= 0 || !is_simple(few)) continue;
        if (outline == nullptr || area(difference_of(*outline, few)) <= spare) return few;
    }
    return region;
}

ExclusiveRegion in_own_frame(Region region) {
    ExclusiveRegion result{.center = center(bounds(region))};
    for (Ring& ring : region)
        for (Point& p : ring) {
            p -= result.center;
            result.radius = std::max(result.radius, abs(p));
        }
    result.area = area(region);
    result.discs = inner_discs(region);
    result.rings = std::move(region);
    return result;
}

ExclusiveRegion region_around(const Region& outline, double closing_share, const ExclusiveRegionOptions& options,
                              const std::string& label) {
    const double size = diagonal(bounds(outline));
    if (!std::isfinite(size) || !(area(outline) > least_area_share * size * size))
        throw InputError({label}, "a shape has no area, so nothing can be kept free around it: give it a fill or a stroke");
    const double tolerance = options.simplification * size;
    const bool holds_outline = options.margin >= 0;
    const Region whole = joined(outline, closing_share * size, options);
    const double margin = options.margin + (holds_outline ? simplification_margin * tolerance : 0);
    const Region grown_region = largest_part(offset_region(whole, margin), options.keep_holes, tolerance * tolerance);
    if (grown_region.empty() || !(area(grown_region) > least_area_share * size * size))
        throw InputError({label}, "the margin leaves nothing of a shape: take a margin that is less negative");
    return in_own_frame(with_few_corners(grown_region, holds_outline ? &outline : nullptr, tolerance));
}

}  // namespace

ExclusiveRegion exclusive_region(const Region& outline, const ExclusiveRegionOptions& options, const std::string& label) {
    return region_around(outline, options.closing, options, label);
}

ExclusiveRegion drawn_exclusive_region(const Region& region, const ExclusiveRegionOptions& options,
                                       const std::string& label) {
    return region_around(region, 0, options, label);
}

}  // namespace rinceau
