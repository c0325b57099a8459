#include "editor/mesh/draw_mesh.h"

#include <algorithm>
#include <cmath>

#include "editor/mesh/stroke_outline.h"
#include "editor/mesh/triangulate.h"

namespace rinceau {
namespace {

bool finite(Point p) { return std::isfinite(p.x) && std::isfinite(p.y); }

bool finite(const Path& path) {
    return finite(path.start) && std::ranges::all_of(path.segments, [](const Segment& segment) {
               return finite(segment.control1) && finite(segment.control2) && finite(segment.to);
           });
}

Contours fill_contours(const std::vector<Path>& paths, double deviation) {
    Contours contours;
    contours.reserve(paths.size());
    for (const Path& path : paths) contours.push_back(flattened(path, deviation));
    return contours;
}

/// Adds the triangles' points to the mesh; their indices there.
std::vector<std::uint32_t> added(DrawMesh& mesh, const Triangles& triangles) {
    const auto first = static_cast<std::uint32_t>(mesh.points.size());
    for (const Point p : triangles.points) {
        mesh.points.push_back({static_cast<float>(p.x), static_cast<float>(p.y)});
        mesh.box = including(mesh.box, p);
    }
    std::vector<std::uint32_t> indices = triangles.indices;
    for (std::uint32_t& index : indices) index += first;
    return indices;
}

}  // namespace

DrawMesh tessellated(const std::vector<Path>& paths, const Style& style, const MeshOptions& options) {
    DrawMesh mesh;
    std::vector<Path> drawn;
    std::ranges::copy_if(paths, std::back_inserter(drawn), [](const Path& path) { return finite(path); });
    if (paints_fill(style)) {
        mesh.fill = added(mesh, triangulated(fill_contours(drawn, options.deviation), style.fill_rule));
    }
    if (paints_stroke(style)) {
        const Contours outline = stroke_outline(drawn, style.stroke, options.stroke_scale, options.deviation);
        mesh.stroke = added(mesh, triangulated(outline, FillRule::nonzero));
    }
    return mesh;
}

}  // namespace rinceau
