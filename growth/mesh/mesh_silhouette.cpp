// Sakurai & Miyata 2014, section 3.3: exclusive regions are made "by the projection into the XZ-plane".
// All triangles lie on one integer grid, so that those that share an edge share it exactly. They are united in a cascade,
// neighbours of the mesh first: each union then works on few edges, where one of all would meet every crossing of the front
// with the back.

#include "growth/mesh/mesh_silhouette.h"

#include <polyclipping/clipper.hpp>

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "scene/input_error.h"

namespace rinceau {
namespace {

using ClipperLib::Paths;

/// Coordinates up to this size stay within Clipper's fast 64-bit products.
constexpr double grid_extent = 5e8;

struct GroundGrid {
    Point origin;
    double scale = 1;  ///< grid steps a unit of the mesh

    ClipperLib::IntPoint to_grid(Point p) const {
        const Point q = scale * (p - origin);
        return {static_cast<ClipperLib::cInt>(std::llround(q.x)), static_cast<ClipperLib::cInt>(std::llround(q.y))};
    }
    Point from_grid(const ClipperLib::IntPoint& p) const {
        return origin + Point{static_cast<double>(p.X), static_cast<double>(p.Y)} / scale;
    }
};

Paths united(const Paths& a, const Paths& b) {
    ClipperLib::Clipper clipper;
    clipper.AddPaths(a, ClipperLib::ptSubject, true);
    clipper.AddPaths(b, ClipperLib::ptSubject, true);
    Paths result;
    clipper.Execute(ClipperLib::ctUnion, result, ClipperLib::pftNonZero, ClipperLib::pftNonZero);
    return result;
}

/// Rounds of pairs: half as many each.
Paths cascaded_union(std::vector<Paths> parts) {
    while (parts.size() > 1) {
        std::vector<Paths> next;
        next.reserve(parts.size() / 2 + 1);
        for (std::size_t i = 0; i + 1 < parts.size(); i += 2) next.push_back(united(parts[i], parts[i + 1]));
        if (parts.size() % 2 == 1) next.push_back(std::move(parts.back()));
        parts = std::move(next);
    }
    return parts.empty() ? Paths{} : std::move(parts.front());
}

std::vector<Paths> seen_from_above(const TriangleMesh& mesh, UpAxis up, const GroundGrid& grid) {
    std::vector<Paths> parts;
    parts.reserve(mesh.triangles.size());
    for (const auto& triangle : mesh.triangles) {
        ClipperLib::Path path;
        for (const int v : triangle)
            path.push_back(grid.to_grid(ground_point(mesh.positions[static_cast<std::size_t>(v)], up)));
        const double area = ClipperLib::Area(path);
        if (area == 0) continue;  // seen edge on
        if (area < 0) ClipperLib::ReversePath(path);
        parts.push_back({std::move(path)});
    }
    return parts;
}

}  // namespace

Point ground_point(SpacePoint p, UpAxis up) { return up == UpAxis::y ? Point{p.x, -p.z} : Point{p.x, p.y}; }

Region silhouette(const TriangleMesh& mesh, UpAxis up, const std::string& label) {
    Box box;
    for (const SpacePoint p : mesh.positions) box = including(box, ground_point(p, up));
    if (!(width(box) > 0 && height(box) > 0)) throw InputError({label}, "seen from above, the mesh has no area");
    const GroundGrid grid{center(box), grid_extent / std::max(width(box), height(box))};
    Paths outline = cascaded_union(seen_from_above(mesh, up, grid));
    // Rounded crossings leave slits a few steps wide; nothing that can be seen is as small as a millionth of the mesh.
    ClipperLib::CleanPolygons(outline, grid_extent * 1e-6);
    Region region;
    for (const ClipperLib::Path& path : outline) {
        if (path.size() < 3) continue;
        std::vector<Point>& ring = region.emplace_back();
        for (const auto& p : path) ring.push_back(grid.from_grid(p));
    }
    if (region.empty()) throw InputError({label}, "seen from above, the mesh has no area");
    return region;
}

MeshPose ground_pose(const Similarity& pose, UpAxis up) {
    const double scale = scale_of(pose), angle = arg(pose.linear);
    const Point at = pose.translation;
    const bool y_up = up == UpAxis::y;
    return {.translation = y_up ? SpacePoint{at.x, 0, -at.y} : SpacePoint{at.x, at.y, 0},
            .rotation = rotation_about(y_up ? SpacePoint{0, 1, 0} : SpacePoint{0, 0, 1}, angle),
            .scale = {scale, scale, scale}};
}

}  // namespace rinceau
