// The dual of the Voronoi diagram of Boost.Polygon (A. Sydorchuk), which is exact for whole numbers of 32 bits.

#include "geometry/delaunay.h"

#include <algorithm>
#include <boost/polygon/voronoi.hpp>
#include <cmath>
#include <cstdint>

#include "geometry/box.h"
#include "geometry/index_map.h"

namespace rinceau {
namespace {

using VoronoiDiagram = boost::polygon::voronoi_diagram<double>;

/// Snapped coordinates lie between plus and minus this.
constexpr double grid_extent = 5e8;

struct GridSite {
    std::int32_t x = 0, y = 0;
    int point = 0;
};

/// The points on the grid, each place once, by its first point.
std::vector<GridSite> snapped_sites(std::span<const Point> points) {
    Box box;
    for (const Point p : points) box = including(box, p);
    const double half = 0.5 * std::max(width(box), height(box));
    const double scale = half > 0 ? grid_extent / half : 0;
    std::vector<GridSite> sites;
    sites.reserve(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point at = scale * (points[i] - center(box));
        sites.push_back({static_cast<std::int32_t>(std::lround(at.x)), static_cast<std::int32_t>(std::lround(at.y)),
                         static_cast<int>(i)});
    }
    const auto key = [](const GridSite& s) { return std::array<std::int32_t, 3>{s.x, s.y, s.point}; };
    std::ranges::sort(sites, {}, key);
    const auto same_place = [](const GridSite& a, const GridSite& b) { return a.x == b.x && a.y == b.y; };
    sites.erase(std::unique(sites.begin(), sites.end(), same_place), sites.end());
    return sites;
}

/// The sites whose cells meet in a Voronoi vertex, counter-clockwise, the lowest point first.
std::vector<int> dual_polygon(const VoronoiDiagram::vertex_type& vertex, const std::vector<GridSite>& sites) {
    std::vector<int> polygon;
    const VoronoiDiagram::edge_type* const first = vertex.incident_edge();
    for (const auto* edge = first;;) {
        polygon.push_back(sites[edge->cell()->source_index()].point);
        edge = edge->rot_next();
        if (edge == first) break;
    }
    std::rotate(polygon.begin(), std::ranges::min_element(polygon), polygon.end());
    return polygon;
}

std::uint64_t directed_edge(int from, int to) {
    return (static_cast<std::uint64_t>(from) << 32U) | static_cast<std::uint32_t>(to);
}

void join_neighbors(std::vector<DelaunayTriangle>& triangles) {
    IndexMap left_of(3 * triangles.size());
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k)
            left_of.set(directed_edge(triangles[t].corners[k], triangles[t].corners[(k + 1) % 3]), static_cast<int>(t));
    for (DelaunayTriangle& triangle : triangles)
        for (std::size_t k = 0; k < 3; ++k)
            triangle.neighbors[k] = left_of.find(directed_edge(triangle.corners[(k + 1) % 3], triangle.corners[k]));
}

}  // namespace

std::vector<DelaunayTriangle> delaunay(std::span<const Point> points) {
    const std::vector<GridSite> sites = snapped_sites(points);
    if (sites.size() < 3) return {};
    boost::polygon::voronoi_builder<std::int32_t> builder;
    for (const GridSite& site : sites) builder.insert_point(site.x, site.y);
    VoronoiDiagram diagram;
    builder.construct(&diagram);
    std::vector<DelaunayTriangle> triangles;
    triangles.reserve(2 * sites.size());
    for (const auto& vertex : diagram.vertices()) {
        const std::vector<int> polygon = dual_polygon(vertex, sites);
        for (std::size_t k = 1; k + 1 < polygon.size(); ++k)
            triangles.push_back({{polygon[0], polygon[k], polygon[k + 1]}, {}});
    }
    std::ranges::sort(triangles, {}, &DelaunayTriangle::corners);
    join_neighbors(triangles);
    return triangles;
}

}  // namespace rinceau
