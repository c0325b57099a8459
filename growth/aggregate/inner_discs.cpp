// Greedy cover on a raster; radii are then measured to the outline itself, so that a disc never leaves the region.

#include "growth/aggregate/inner_discs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/polygon.h"
#include "growth/aggregate/distance_transform.h"

namespace rinceau {
namespace {

constexpr int raster_side = 96;        // cells along the longer side of the box
constexpr double cover_factor = 1.15;  // a disc of so many times the radius is taken as covered

bool inside(const Region& region, Point p) {
    bool result = false;
    for (const auto& ring : region) result ^= inside_evenodd(ring, p);
    return result;
}

double distance_to_outline(const Region& region, Point p) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const auto& ring : region)
        for (std::size_t i = 0; i < ring.size(); ++i)
            nearest = std::min(nearest, distance_to_segment(p, ring[i], ring[(i + 1) % ring.size()]));
    return nearest;
}

struct Raster {
    Box box;
    double step = 1;
    CellMask outside;

    Point middle(std::size_t cell) const {
        const auto columns = static_cast<std::size_t>(outside.columns);
        return box.low + step * Point{static_cast<double>(cell % columns) + 0.5, static_cast<double>(cell / columns) + 0.5};
    }
};

/// One cell around the box is outside, so that every distance is finite.
Raster raster_of(const Region& region) {
    Raster raster{.box = bounds(region)};
    raster.step = std::max(width(raster.box), height(raster.box)) / raster_side;
    raster.box = grown(raster.box, raster.step);
    raster.outside.columns = static_cast<int>(std::ceil(width(raster.box) / raster.step));
    raster.outside.rows = static_cast<int>(std::ceil(height(raster.box) / raster.step));
    raster.outside.marked.resize(static_cast<std::size_t>(raster.outside.columns) *
                                 static_cast<std::size_t>(raster.outside.rows));
    for (std::size_t cell = 0; cell < raster.outside.marked.size(); ++cell)
        raster.outside.marked[cell] = !inside(region, raster.middle(cell));
    return raster;
}

/// A region so thin that no cell's middle lies inside: the best of the points beside the middles of its edges.
InnerDisc disc_of_thin(const Region& region) {
    InnerDisc best;
    for (const auto& ring : region)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            const Point a = ring[i], b = ring[(i + 1) % ring.size()], c = ring[(i + 2) % ring.size()];
            const Point p = (a + b + c) / 3;
            const double radius = inside(region, p) ? distance_to_outline(region, p) : 0;
            if (radius > best.radius) best = {p, radius};
        }
    return best;
}

}  // namespace

std::vector<InnerDisc> inner_discs(const Region& region, std::size_t max_count) {
    const Raster raster = raster_of(region);
    const std::vector<float> depth = distances_to_marked(raster.outside, {raster.step, raster.step});
    std::vector<std::size_t> order(depth.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::erase_if(order, [&](std::size_t cell) { return depth[cell] <= 0; });
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return depth[a] > depth[b]; });

    std::vector<InnerDisc> discs;
    for (const std::size_t cell : order) {
        if (discs.size() == max_count) break;
        const Point p = raster.middle(cell);
        const auto covers = [p](const InnerDisc& disc) { return abs(p - disc.center) < cover_factor * disc.radius; };
        if (std::ranges::any_of(discs, covers)) continue;
        discs.push_back({p, distance_to_outline(region, p)});
    }
    if (discs.empty()) discs.push_back(disc_of_thin(region));
    std::ranges::stable_sort(discs, [](const InnerDisc& a, const InnerDisc& b) { return a.radius > b.radius; });
    return discs;
}

}  // namespace rinceau
