#include "cli/grow_output.h"

#include <algorithm>
#include <cmath>

#include "files/files.h"
#include "files/output_file.h"
#include "geometry/angle.h"
#include "growth/mesh/mesh_obj_write.h"
#include "growth/mesh/mesh_picture.h"
#include "growth/mesh/mesh_ply_write.h"
#include "growth/surface/pattern_svg.h"
#include "scene/svg_raster.h"

namespace rinceau {
namespace {

/// Where the pattern faces: the sum of all normals, weighted by area, and of their lengths.
struct Facing {
    SpacePoint sum;
    double area = 0;

    void add(SpacePoint normal, double weight) {
        sum = sum + weight * normal;
        area += weight * abs(normal);
    }
};

Facing facing(const SurfacePattern& pattern) {
    Facing facing;
    for (const PatternShape& shape : pattern.placed) facing.add(shape.axes[2], shape.size.x * shape.size.y);
    for (const PatternLine& line : pattern.lines)
        for (std::size_t i = 1; i < line.points.size(); ++i)
            facing.add(line.normals[i], line.widths[i] * abs(line.points[i] - line.points[i - 1]));
    for (const NamedMesh& laid : pattern.laid)
        for (const auto& [a, b, c] : laid.mesh.triangles) {
            const auto corner = [&](int i) { return laid.mesh.positions[static_cast<std::size_t>(i)]; };
            facing.add(cross(corner(b) - corner(a), corner(c) - corner(a)), 0.5);
        }
    return facing;
}

/// Towards a pattern that is on one side of its surface; from the side of one that is all round it.
LookFrom look_at(const SurfacePattern& pattern, UpAxis up) {
    constexpr double one_sided = 0.3;  // of the normals' lengths that their sum keeps
    const Facing whole = facing(pattern);
    if (!(abs(whole.sum) > one_sided * whole.area)) return {};
    const SpacePoint to_eye = unit(whole.sum);
    const double height = up == UpAxis::y ? to_eye.y : to_eye.z;
    const double turn = up == UpAxis::y ? std::atan2(to_eye.x, to_eye.z) : std::atan2(to_eye.x, -to_eye.y);
    constexpr double lowest = -20, highest = 60;  // so that the surface still stands upright
    return {degrees(turn), std::clamp(degrees(std::asin(std::clamp(height, -1.0, 1.0))), lowest, highest)};
}

std::string picture_bytes(const SurfacePattern& pattern, const SurfaceMesh& surface, const GrowVerbOptions& options) {
    const bool plane = options.surface.empty();
    const UpAxis up = plane ? UpAxis::z : options.up;
    constexpr double straight_down = 90;
    const LookFrom look = options.view.value_or(plane ? LookFrom{0, straight_down} : look_at(pattern, up));
    constexpr double occlusion = 0.6;
    MeshView view{.elevation = radians(look.elevation), .turn = radians(look.turn), .occlusion = occlusion};
    if (options.width > 0) view.width = options.width;
    return picture_to_png(mesh_picture(assembly_of(pattern, surface, {.with_surface = true}), up, view));
}

Box box_of(const SurfaceMesh& surface) {
    Box box;
    for (const SpacePoint p : surface.mesh.positions) box = including(box, Point{p.x, p.y});
    return box;
}

}  // namespace

long write_grown(const SurfacePattern& pattern, const SurfaceMesh& surface, const GrowVerbOptions& options) {
    const MeshAssembly assembly = assembly_of(pattern, surface, {.with_surface = options.with_surface});
    switch (format_of(options.output, options.surface.empty() ? FileFormat::svg : FileFormat::obj)) {
        case FileFormat::obj: {
            OutputFile file(options.output);
            write_obj(assembly, [&](std::string_view piece) { file.write(piece); }, {.colors = true, .normals = true});
            file.finish();
            break;
        }
        case FileFormat::ply: {
            OutputFile file(options.output);
            write_ply(assembly, [&](std::string_view piece) { file.write(piece); });
            file.finish();
            break;
        }
        case FileFormat::glb:
            write_output(options.output, glb_bytes(assembly, {.up = options.up, .instancing = options.instancing}));
            break;
        case FileFormat::png:
            write_output(options.output, picture_bytes(pattern, surface, options));
            break;
        default: {
            constexpr double usual_width = 1000;
            write_output(options.output,
                         pattern_svg(pattern, box_of(surface), options.width > 0 ? options.width : usual_width));
        }
    }
    return faces_out(assembly);
}

}  // namespace rinceau
