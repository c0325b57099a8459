// Of points: every largest empty circle is the circle about a Delaunay triangle. Of regions: the deepest cells of a raster,
// then moved uphill with exact distances from outlines.

#include "growth/measure/empty_circle.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/box_tree.h"
#include "geometry/delaunay.h"
#include "geometry/polygon.h"
#include "growth/measure/outline_overlaps.h"

namespace rinceau {
namespace {

constexpr std::size_t gap_cells = 500'000;
constexpr std::size_t tried_cells = 24;  ///< deepest ones, from which the way uphill is begun
constexpr double precision = 1e-3;       ///< of the radius

struct Circumcircle {
    Point center;
    double radius = 0;
};

Circumcircle circle_about(Point a, Point b, Point c) {
    const Point u = b - a, v = c - a;
    const double twice = 2 * cross(u, v);
    const Point middle = Point{v.y * norm(u) - u.y * norm(v), u.x * norm(v) - v.x * norm(u)} / twice;
    return {a + middle, abs(middle)};
}

/// All edges of outlines, for the distance to the nearest one.
class OutlineDistance {
  public:
    explicit OutlineDistance(const std::vector<Region>& regions) {
        for (const Region& region : regions)
            for (const auto& ring : region)
                for (std::size_t i = 0; i < ring.size(); ++i) edges_.push_back({ring[i], ring[(i + 1) % ring.size()]});
        std::vector<Box> boxes;
        boxes.reserve(edges_.size());
        for (const auto& edge : edges_) boxes.push_back(including(including(Box{}, edge[0]), edge[1]));
        tree_ = BoxTree(boxes);
    }
    /// At most `limit`.
    double at(Point p, double limit) const {
        double nearest = limit;
        tree_.visit(grown(including(Box{}, p), limit), [&](std::size_t i) {
            nearest = std::min(nearest, distance_to_segment(p, edges_[i][0], edges_[i][1]));
            return true;
        });
        return nearest;
    }

  private:
    std::vector<std::array<Point, 2>> edges_;
    BoxTree tree_;
};

/// Uphill in eight directions with steps that are halved.
EmptyCircle risen(EmptyCircle circle, const OutlineDistance& distance, double step) {
    const auto radius_at = [&](Point p) { return distance.at(p, circle.radius + 4 * step); };
    circle.radius = distance.at(circle.center, circle.radius + 4 * step);
    while (step > precision * circle.radius) {
        EmptyCircle best = circle;
        for (int k = 0; k < 8; ++k) {
            const Point p = circle.center + polar(step, k * 0.25 * pi);
            if (const double radius = radius_at(p); radius > best.radius) best = {p, radius};
        }
        if (best.radius > circle.radius * (1 + 0.1 * precision)) {
            circle = best;
        } else {
            step *= 0.5;
        }
    }
    return circle;
}

Region box_region(const Box& box) { return {{box.low, {box.high.x, box.low.y}, box.high, {box.low.x, box.high.y}}}; }

/// Regions that reach over the edge of a tile or stand near it, moved by whole tiles into the ground that is looked at.
std::vector<Region> with_copies(const std::vector<Region>& regions, const Box& tile, const Box& ground) {
    std::vector<Region> all;
    for (const Region& region : regions) {
        const Box box = bounds(region);
        for (int row = -2; row <= 2; ++row)
            for (int column = -2; column <= 2; ++column) {
                const Point step{column * width(tile), row * height(tile)};
                if (overlap({box.low + step, box.high + step}, ground))
                    all.push_back(placed_region(region, translate(step)));
            }
    }
    return all;
}

}  // namespace

EmptyCircle largest_empty_circle(const PointPattern& pattern, double inward) {
    const std::vector<double> depth = depths(pattern.window);
    EmptyCircle largest;
    for (const DelaunayTriangle& triangle : delaunay(pattern.positions)) {
        const auto corner = [&](std::size_t k) { return pattern.positions[static_cast<std::size_t>(triangle.corners[k])]; };
        const Circumcircle circle = circle_about(corner(0), corner(1), corner(2));
        if (!(circle.radius > largest.radius)) continue;
        const std::ptrdiff_t cell = cell_at(pattern.window, circle.center);
        if (cell < 0 || depth[static_cast<std::size_t>(cell)] < circle.radius + inward) continue;
        largest = {circle.center, circle.radius};
    }
    return largest;
}

EmptyCircle largest_gap(const std::vector<Region>& regions, const PackDomain& domain) {
    // On a tile the ground reaches half a tile beyond: no gap that is not deeper than that is cut off.
    const Box ground = domain.tiled ? grown(domain.box, 0.5 * std::max(width(domain.box), height(domain.box))) : domain.box;
    const std::vector<Region> obstacles = domain.tiled ? with_copies(regions, domain.box, ground) : regions;
    Mask covered = empty_mask(ground, gap_cells);
    Mask free = covered;
    for (const Region& region : obstacles) covered = with_region(std::move(covered), region);
    const Region border = domain.region && !domain.tiled ? *domain.region : box_region(ground);
    free = with_region(std::move(free), border);
    for (std::size_t cell = 0; cell < free.inside.size(); ++cell)
        if (covered.inside[cell] != 0) free.inside[cell] = 0;

    const std::vector<double> depth = depths(free);
    std::vector<std::size_t> cells;
    for (std::size_t cell = 0; cell < depth.size(); ++cell)
        if (depth[cell] > 0 && overlap(domain.box, including(Box{}, cell_center(free, cell)))) cells.push_back(cell);
    const std::size_t tried = std::min(tried_cells, cells.size());
    std::partial_sort(cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(tried), cells.end(),
                      [&](std::size_t a, std::size_t b) { return depth[a] != depth[b] ? depth[a] > depth[b] : a < b; });
    std::vector<Region> outlines = obstacles;
    if (!domain.tiled) outlines.push_back(border);
    const OutlineDistance distance(outlines);
    EmptyCircle largest;
    for (std::size_t k = 0; k < tried; ++k) {
        const EmptyCircle circle = risen({cell_center(free, cells[k]), depth[cells[k]]}, distance, free.cell);
        if (circle.radius > largest.radius) largest = circle;
    }
    return largest;
}

}  // namespace rinceau
