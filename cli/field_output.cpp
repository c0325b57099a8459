#include "cli/field_output.h"

#include <map>
#include <nlohmann/json.hpp>

#include "files/files.h"
#include "files/output_file.h"
#include "geometry/angle.h"
#include "growth/mesh/mesh_obj_write.h"
#include "growth/mesh/mesh_picture.h"
#include "growth/mesh/mesh_ply_write.h"
#include "growth/surface/field_filled.h"
#include "growth/surface/field_picture.h"
#include "scene/svg_raster.h"
#include "scene/svg_write.h"

namespace rinceau {
namespace {

constexpr int schema_version = 1;

std::string picture_bytes(const SurfacePattern& pattern, const SurfaceMesh& surface, const FieldVerbOptions& options) {
    const bool plane = is_plane(surface);
    constexpr double straight_down = 90, occlusion = 0.5;
    const LookFrom look = options.view.value_or(plane ? LookFrom{0, straight_down} : LookFrom{});
    const MeshView view{.elevation = radians(look.elevation),
                        .width = options.width,
                        .turn = radians(look.turn),
                        .occlusion = plane ? 0 : occlusion};
    return picture_to_png(
        mesh_picture(assembly_of(pattern, surface, {.with_surface = true}), plane ? UpAxis::z : options.up, view));
}

std::string plane_svg(const SurfacePattern& pattern, const SurfaceMesh& surface, const std::string& output) {
    if (!is_plane(surface))
        throw CLI::ValidationError("-o", "'" + output +
                                             "': SVG is for fields of the plane, and the surface is not flat; "
                                             "write a .png");
    return write_svg(field_scene(pattern, surface));
}

void write_pattern(const SurfacePattern& pattern, const SurfaceMesh& surface, const std::string& output,
                   const FieldVerbOptions& options) {
    switch (format_of(output, FileFormat::json)) {
        case FileFormat::png:
            write_output(output, picture_bytes(pattern, surface, options));
            break;
        case FileFormat::svg:
            write_output(output, plane_svg(pattern, surface, output));
            break;
        case FileFormat::glb:
            write_output(output, glb_bytes(assembly_of(pattern, surface), {.up = options.up}));
            break;
        case FileFormat::ply: {
            OutputFile file(output);
            write_ply(assembly_of(pattern, surface), [&](std::string_view piece) { file.write(piece); });
            file.finish();
            break;
        }
        default: {
            OutputFile file(output);
            write_obj(assembly_of(pattern, surface), [&](std::string_view piece) { file.write(piece); }, {.colors = true});
            file.finish();
        }
    }
}

}  // namespace

void write_field(const FieldOnSurface& field, const FieldVerbOptions& options, const Progress& progress) {
    const SurfaceMesh& surface = field.surface();
    const auto is_values = [](const std::string& name) { return format_of(name, FileFormat::json) == FileFormat::json; };
    std::vector<std::string> outputs = options.outputs;
    if (outputs.empty()) outputs.emplace_back("-");
    FieldPictureOptions look{.minor = options.minor, .points = options.points};
    if (options.spacing > 0) look.spacing = options.spacing;
    std::optional<SurfacePattern> pattern;
    for (const std::string& output : outputs) {
        if (is_values(output)) {
            write_output(output, field_json(field.field(), surface, options.frame));
            continue;
        }
        if (!pattern) pattern = field_pattern(field, look, progress);
        write_pattern(*pattern, surface, output, options);
    }
}

std::string field_report(const FieldOnSurface& field, const FieldSummary& summary, const FieldVerbOptions& options) {
    using Json = nlohmann::ordered_json;
    const SurfaceMesh& surface = field.surface();
    Json json{{"schema", schema_version}, {"input", options.surface.empty() ? "plane" : options.surface}};
    json["vertices"] = surface.vertices();
    json["faces"] = surface.faces();
    json["border_edges"] = surface.border_edges;
    json["n"] = field.n();
    std::map<int, int> by_index;
    for (const int face : field.singular_faces()) ++by_index[field.index(face)];
    Json points = Json::array();
    for (const auto& [index, count] : by_index)
        points.push_back({{"index", static_cast<double>(index) / field.n()}, {"count", count}});
    json["singularities"] = {{"before", summary.singular_before},
                             {"after", field.singular_faces().size()},
                             {"by_index", points},
                             {"sum", static_cast<double>(field.index_sum()) / field.n()},
                             {"euler", euler_characteristic(surface)}};
    json["warnings"] = summary.warnings;
    json["seconds"] = {{"total", summary.total_seconds}};
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace rinceau
