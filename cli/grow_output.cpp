#include "cli/grow_output.h"

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

std::string picture_bytes(const SurfacePattern& pattern, const SurfaceMesh& surface, const GrowVerbOptions& options) {
    const bool plane = options.surface.empty();
    constexpr double from_the_side = 30, from_above = 20, straight_down = 90;
    const auto [turn, elevation] =
        options.view.value_or(plane ? std::pair(0.0, straight_down) : std::pair(from_the_side, from_above));
    constexpr double occlusion = 0.6;
    MeshView view{.elevation = radians(elevation), .turn = radians(turn), .occlusion = occlusion};
    if (options.width > 0) view.width = options.width;
    const UpAxis up = plane ? UpAxis::z : options.up;
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
