#include "growth/mesh/region_triangles.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "geometry/index_map.h"
#include "growth/mesh/constrained_delaunay.h"

namespace rinceau {
namespace {

/// Half of the steps of a grid from -5e8 to 5e8: all coordinates are even, so that the middle of the grid is on it.
constexpr double half_steps = 2.5e8;

struct CornersOnGrid {
    std::vector<GridPoint> places;        ///< each once
    std::vector<Point> points;            ///< the first corner of each place
    std::vector<std::vector<int>> rings;  ///< places
};

CornersOnGrid corners_on_grid(const Region& region) {
    const Box box = bounds(region);
    const double half = 0.5 * std::max(width(box), height(box));
    CornersOnGrid corners;
    if (!(half > 0)) return corners;
    IndexMap known;
    for (const auto& ring : region) {
        std::vector<int>& places = corners.rings.emplace_back();
        for (const Point p : ring) {
            const Point q = (half_steps / half) * (p - center(box));
            const GridPoint place{2 * std::llround(q.x), 2 * std::llround(q.y)};
            const auto key =
                (static_cast<std::uint64_t>(place.x) << 32U) ^ (static_cast<std::uint64_t>(place.y) & 0xFFFFFFFFU);
            const int index = known.find_or_insert(key, static_cast<int>(corners.places.size()));
            if (index == static_cast<int>(corners.places.size())) {
                corners.places.push_back(place);
                corners.points.push_back(p);
            }
            if (places.empty() || places.back() != index) places.push_back(index);
        }
    }
    return corners;
}

std::vector<std::array<int, 2>> borders_of(const std::vector<std::array<int, 3>>& triangles) {
    const auto key = [](int from, int to) {
        return (static_cast<std::uint64_t>(from) << 32U) | static_cast<std::uint32_t>(to);
    };
    IndexMap edges(3 * triangles.size());
    for (const auto& t : triangles)
        for (std::size_t k = 0; k < 3; ++k) edges.set(key(t[k], t[(k + 1) % 3]), 0);
    std::vector<std::array<int, 2>> borders;
    for (const auto& t : triangles)
        for (std::size_t k = 0; k < 3; ++k)
            if (edges.find(key(t[(k + 1) % 3], t[k])) == IndexMap::none) borders.push_back({t[k], t[(k + 1) % 3]});
    return borders;
}

}  // namespace

RegionTriangles region_triangles(const Region& region) {
    const CornersOnGrid corners = corners_on_grid(region);
    if (corners.places.size() < 3) return {};
    ConstrainedDelaunay triangulation(corners.places);
    for (const auto& ring : corners.rings)
        for (std::size_t i = 0; i < ring.size(); ++i) triangulation.draw(ring[i], ring[(i + 1) % ring.size()]);
    triangulation.relax();
    RegionTriangles result{corners.points, triangulation.inside(), {}};
    result.borders = borders_of(result.triangles);
    return result;
}

}  // namespace rinceau
