#include "cli/pack_output.h"

#include <nlohmann/json.hpp>

#include "cli/growth_output.h"
#include "files/output_file.h"
#include "growth/aggregate/height_picture_png.h"
#include "growth/mesh/mesh_obj_write.h"
#include "growth/mesh/mesh_picture.h"
#include "growth/mesh/mesh_silhouette.h"
#include "scene/svg_raster.h"

namespace rinceau {
namespace {

using Json = nlohmann::ordered_json;

Box drawn_box(const PackShape& shape, const Similarity& pose) {
    Box box;
    for (const std::vector<Point>& ring : shape.outline)
        for (const Point p : ring) box = including(box, apply(pose, p));
    return box;
}

/// The figures where they were placed; those that reach over the border of a tile also on the other side.
std::vector<PlacedFigure> placed_figures(const PackShapes& shapes, const std::vector<PlacedRegion>& placed,
                                         const PackDomain& domain) {
    std::vector<PlacedFigure> figures;
    const int beyond = domain.tiled ? 1 : 0;
    for (const PlacedRegion& region : placed) {
        const PackShape& shape = shapes.shapes[static_cast<std::size_t>(region.shape)];
        for (int across = -beyond; across <= beyond; ++across)
            for (int up = -beyond; up <= beyond; ++up) {
                const Point shift{across * width(domain.box), up * height(domain.box)};
                const Similarity pose = translate(shift) * region.pose;
                const bool original = across == 0 && up == 0;
                if (original || overlap(drawn_box(shape, pose), domain.box))
                    figures.push_back({region.shape, pose * shape.to_region, {}});
            }
    }
    return figures;
}

Json point_json(Point p) { return Json::array({p.x, 0 - p.y}); }

Json shape_json(const PackShapes& shapes, std::size_t index) {
    const ExclusiveRegion& region = shapes.shapes[index].region;
    Json rings = Json::array();
    for (const std::vector<Point>& ring : region.rings) {
        Json corners = Json::array();
        for (const Point p : ring) corners.push_back(point_json(p));
        rings.push_back(corners);
    }
    return {{"symbol", shapes.drawing.figures[index].symbol},
            {"radius", region.radius},
            {"area", region.area},
            {"region", rings}};
}

/// Everything as SVG has it, y down; angles clockwise.
std::string placements_json(const PackShapes& shapes, const std::vector<PlacedRegion>& placed, const PackDomain& domain) {
    Json json{{"format", "rinceau-aggregate"}, {"version", 1}};
    json["canvas"] = {domain.box.low.x, 0 - domain.box.high.y, width(domain.box), height(domain.box)};
    json["tile"] = domain.tiled;
    json["shapes"] = Json::array();
    for (std::size_t i = 0; i < shapes.shapes.size(); ++i) json["shapes"].push_back(shape_json(shapes, i));
    json["placements"] = Json::array();
    constexpr double degrees = 180 / pi;
    for (const PlacedRegion& region : placed)
        json["placements"].push_back({{"shape", region.shape},
                                      {"x", region.pose.translation.x},
                                      {"y", 0 - region.pose.translation.y},
                                      {"angle", 0 - degrees * arg(region.pose.linear)},
                                      {"scale", scale_of(region.pose)}});
    return json.dump(1) + "\n";
}

MeshAssembly assembly_of(const PackShapes& shapes, const std::vector<PlacedRegion>& placed, UpAxis up) {
    MeshAssembly assembly{.meshes = shapes.meshes};
    for (const PlacedRegion& region : placed) assembly.instances.push_back({region.shape, ground_pose(region.pose, up)});
    return assembly;
}

void write_aggregate(const PackShapes& shapes, const std::vector<PlacedRegion>& placed, const PackDomain& domain,
                     const PackVerbOptions& options) {
    const FileFormat format = format_of(options.output, FileFormat::svg);
    if (format == FileFormat::png && !shapes.meshes.empty()) {
        MeshView view;
        if (options.width > 0) view.width = options.width;
        return write_output(options.output,
                            picture_to_png(mesh_picture(assembly_of(shapes, placed, options.up), options.up, view)));
    }
    switch (format) {
        case FileFormat::obj: {
            OutputFile file(options.output);
            write_obj(assembly_of(shapes, placed, options.up), [&](std::string_view piece) { file.write(piece); });
            return file.finish();
        }
        case FileFormat::glb:
            return write_output(options.output, glb_bytes(assembly_of(shapes, placed, options.up), options.up));
        case FileFormat::json:
            return write_output(options.output, placements_json(shapes, placed, domain));
        default:
            write_growth(shapes.drawing, placed_figures(shapes, placed, domain), domain.box, options.output, options.width);
    }
}

void write_relief(const PackShapes& shapes, const std::vector<PlacedRegion>& placed, const PackDomain& domain,
                  const PackVerbOptions& options, const Progress& progress) {
    if (options.height_map.empty() && options.shaded.empty()) return;
    std::vector<Region> cristae, sulci;
    for (const PackShape& shape : shapes.shapes) {
        cristae.push_back(shape.outline);
        if (!options.sulci.empty()) sulci.push_back(shape.sulcus);
    }
    HeightMapOptions relief = options.relief;
    if (options.width > 0) relief.columns = options.width;
    const HeightMap map = height_map(cristae, sulci, placed, domain, relief, progress);
    if (!options.height_map.empty()) write_output(options.height_map, height_png(map));
    if (!options.shaded.empty()) write_output(options.shaded, picture_to_png(shaded_relief(map, {.tiled = domain.tiled})));
}

}  // namespace

void write_pack(const PackShapes& shapes, const std::vector<PlacedRegion>& placed, const PackDomain& domain,
                const PackVerbOptions& options, const Progress& progress) {
    write_aggregate(shapes, placed, domain, options);
    write_relief(shapes, placed, domain, options, progress);
}

}  // namespace rinceau
