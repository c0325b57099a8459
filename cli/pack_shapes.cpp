// Each shape stands upright in the frame of its exclusive region: as its first whole copy stands in the drawing, so that
// angle 0 and scale 1 mean what a person sees there, wherever the analysis has put the terminal's own heading.

#include "cli/pack_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <optional>

#include "analyzer/analyze.h"
#include "cli/growth_input.h"
#include "growth/merge_figures.h"
#include "growth/mesh/mesh_obj_read.h"
#include "growth/mesh/mesh_silhouette.h"

namespace rinceau {
namespace {

/// A file with shapes, and how to get from each figure to the file's plane.
struct ShapeFile {
    GrowthInput input;
    std::vector<Similarity> drawn;  ///< figure -> scene, of its first whole instance
    std::optional<TriangleMesh> mesh;

    const FiguredDrawing& drawing() const { return input.drawing; }
};

ShapeFile shape_file(GrowthInput input) {
    ShapeFile file{.input = std::move(input)};
    if (file.drawing().figures.empty())
        throw InputError({file.input.label}, "expected shapes that enclose an area, found none");
    for (std::size_t i = 0; i < file.drawing().figures.size(); ++i) {
        const auto is_copy = [i](const FigureInstance& instance) {
            return instance.whole && instance.figure == static_cast<int>(i);
        };
        const auto first = std::ranges::find_if(file.drawing().instances, is_copy);
        file.drawn.push_back(first == file.drawing().instances.end() ? Similarity{} : first->pose);
    }
    return file;
}

/// Colours that are told apart beside each other, for meshes, which bring none.
constexpr std::array<Color, 6> mesh_colors{
    {{214, 111, 74}, {74, 130, 168}, {232, 186, 82}, {106, 153, 96}, {142, 108, 158}, {196, 188, 172}}};

Color mesh_color(std::size_t index) { return mesh_colors[index % mesh_colors.size()]; }

Path closed_path(const std::vector<Point>& ring) {
    Path path{.start = ring.front(), .closed = true};
    for (std::size_t i = 1; i < ring.size(); ++i) path.segments.push_back(line_to(ring[i]));
    return path;
}

/// The mesh as it is seen from above: a drawing of one shape.
Scene silhouette_scene(const TriangleMesh& mesh, UpAxis up, const std::string& label, Color color) {
    const Region region = silhouette(mesh, up, label);
    Element element;
    for (const std::vector<Point>& ring : region) element.paths.push_back(closed_path(ring));
    element.style.fill = color;
    element.style.fill_rule = FillRule::evenodd;
    return {.viewport = bounds(region), .elements = {element}};
}

TriangleMesh read_mesh(const std::string& name) { return read_obj(read_input(name), {.file_name = input_label(name)}); }

ShapeFile read_mesh_file(const std::string& name, const PackVerbOptions& options, std::size_t index) {
    const std::string label = input_label(name);
    TriangleMesh mesh = read_mesh(name);
    const Scene scene = silhouette_scene(mesh, options.up, label, mesh_color(index));
    ShapeFile file = shape_file({.label = label, .drawing = figures_of(analyze(scene).grammar, {.one_figure = true})});
    file.mesh = std::move(mesh);
    return file;
}

std::vector<ShapeFile> read_files(const PackVerbOptions& options) {
    const FigureOptions figure_options{.raised = options.raised, .one_figure = options.shapes.size() > 1};
    std::vector<ShapeFile> files;
    for (const std::string& name : options.shapes)
        files.push_back(from_meshes(options) ? read_mesh_file(name, options, files.size())
                                             : shape_file(read_growth_input(name, figure_options, options.threads)));
    return files;
}

/// A shape that is known by its file and its number there.
struct ShapePlace {
    const ShapeFile* file = nullptr;
    std::size_t figure = 0;

    const Figure& shape() const { return file->drawing().figures[figure]; }
    Similarity drawn() const { return file->drawn[figure]; }
    /// For messages: the file, and the symbol if it has several shapes.
    std::string label() const {
        return file->drawing().figures.size() > 1 ? file->input.label + ", shape " + shape().symbol : file->input.label;
    }
};

std::vector<ShapePlace> all_shapes(const std::vector<ShapeFile>& files) {
    std::vector<ShapePlace> places;
    for (const ShapeFile& file : files)
        for (std::size_t i = 0; i < file.drawing().figures.size(); ++i) places.push_back({&file, i});
    return places;
}

Region moved(const Similarity& pose, Region region) {
    for (std::vector<Point>& ring : region)
        for (Point& p : ring) p = apply(pose, p);
    return region;
}

/// What `option` draws over the shapes, in the shapes' order and in the scenes of their files: an outline for each element
/// of a drawing that holds as many as there are shapes, or a whole drawing for each shape.
std::vector<Region> drawn_over(const std::vector<std::string>& names, const std::string& option,
                               const std::vector<ShapePlace>& shapes) {
    std::vector<Region> regions;
    for (const std::string& name : names) {
        const Scene scene = read_guide(name);
        const double deviation = guide_deviation(scene);
        if (names.size() > 1) {
            regions.push_back(region_of(scene, deviation, input_label(name)));
            continue;
        }
        for (const Element& element : scene.elements)
            regions.push_back(region_of({.viewport = scene.viewport, .elements = {element}}, deviation, input_label(name)));
    }
    const std::string label = input_label(names.front());
    if (regions.size() != shapes.size())
        throw InputError({label}, option + ": expected an outline for each of the " + std::to_string(shapes.size()) +
                                      " shapes, found " + std::to_string(regions.size()));
    for (std::size_t i = 0; i < shapes.size(); ++i)
        if (area(intersection_of(regions[i], moved(shapes[i].drawn(), shapes[i].shape().outline))) <= 0)
            throw InputError({label},
                             option + ": outline " + std::to_string(i + 1) + " is not drawn over " + shapes[i].label());
    return regions;
}

/// Turned, scaled and mirrored as it is drawn, about the figure's own origin.
Similarity upright(const ShapePlace& shape) { return {shape.drawn().linear, {}, shape.drawn().mirrored}; }

/// From the plane of the file to upright(): a move.
Similarity to_upright(const ShapePlace& shape) { return translate(-shape.drawn().translation); }

/// The circle about the outline's box that holds it (section 4.1, figure 9): what earlier methods keep free.
Region circle_about(const Region& outline) {
    constexpr int corners = 64;
    const Point middle = center(bounds(outline));
    double radius = 0;
    for (const std::vector<Point>& ring : outline)
        for (const Point p : ring) radius = std::max(radius, abs(p - middle));
    std::vector<Point> circle;
    for (int i = 0; i < corners; ++i)
        circle.push_back(middle + polar(radius / std::cos(pi / corners), two_pi * i / corners));
    return {circle};
}

PackShape pack_shape(const ShapePlace& place, const Region* drawn, const Region* sulcus, const PackVerbOptions& options) {
    PackShape shape;
    const Region outline = moved(upright(place), place.shape().outline);
    if (drawn != nullptr) {
        shape.region = drawn_exclusive_region(moved(to_upright(place), *drawn), options.exclusive, place.label());
    } else if (keeps_circles(options)) {
        shape.region = drawn_exclusive_region(circle_about(outline), options.exclusive, place.label());
    } else {
        shape.region = exclusive_region(outline, options.exclusive, place.label());
    }
    const Similarity to_center = translate(-shape.region.center);
    shape.to_region = to_center * upright(place);
    shape.outline = moved(to_center, outline);
    if (sulcus != nullptr) shape.sulcus = moved(to_center * to_upright(place), *sulcus);
    return shape;
}

/// The mesh upon the ground, with the middle of its box over `at`, `scale` times as large.
TriangleMesh stood_up(TriangleMesh mesh, UpAxis up, Point at, double scale) {
    const auto [low, high] = bounds(mesh);
    const Point middle = 0.5 * (ground_point(low, up) + ground_point(high, up));
    const SpacePoint foot = up == UpAxis::y ? SpacePoint{middle.x, low.y, -middle.y} : SpacePoint{middle.x, middle.y, low.z};
    const SpacePoint to = up == UpAxis::y ? SpacePoint{at.x, 0, -at.y} : SpacePoint{at.x, at.y, 0};
    for (SpacePoint& p : mesh.positions) p = scale * (p - foot) + to;
    return mesh;
}

Box ground_box(const TriangleMesh& mesh, UpAxis up) {
    Box box;
    for (const SpacePoint p : mesh.positions) box = including(box, ground_point(p, up));
    return box;
}

/// As large as fits into the shape's box, in the middle of it.
TriangleMesh fitted(const TriangleMesh& mesh, UpAxis up, const Box& to, const std::string& label) {
    const Box box = ground_box(mesh, up);
    if (!(width(box) > 0 && height(box) > 0)) throw InputError({label}, "seen from above, the mesh has no area");
    return stood_up(mesh, up, center(to), std::min(width(to) / width(box), height(to) / height(box)));
}

Color first_color(const FiguredDrawing& drawing, const Figure& figure) {
    for (const Placement& part : figure.parts) {
        const int number =
            part.style != 0 ? part.style : drawing.grammar.terminals[static_cast<std::size_t>(part.terminal)].style;
        const auto style = std::ranges::find(drawing.grammar.styles, number, &NumberedStyle::number);
        if (style == drawing.grammar.styles.end()) continue;
        if (const Color* color = std::get_if<Color>(&style->style.fill)) return *color;
    }
    return NamedMesh{}.color;
}

std::vector<NamedMesh> meshes_of(const PackShapes& shapes, const std::vector<ShapePlace>& places,
                                 const PackVerbOptions& options) {
    std::vector<NamedMesh> meshes;
    if (!options.meshes.empty() && options.meshes.size() != places.size())
        throw InputError({input_label(options.shapes.front())}, "--meshes: expected a mesh for each of the " +
                                                                    std::to_string(places.size()) + " shapes, found " +
                                                                    std::to_string(options.meshes.size()));
    for (std::size_t i = 0; i < places.size(); ++i) {
        const Figure& figure = shapes.drawing.figures[i];
        const Box box = bounds(shapes.shapes[i].outline);
        if (!options.meshes.empty()) {
            const std::string& name = options.meshes[i];
            meshes.push_back({figure.symbol, fitted(read_mesh(name), options.up, box, input_label(name)),
                              first_color(shapes.drawing, figure)});
        } else if (places[i].file->mesh) {
            meshes.push_back({figure.symbol, stood_up(*places[i].file->mesh, options.up, center(box), 1), mesh_color(i)});
        }
    }
    return meshes;
}

/// One drawing as it is; several under the names of their files.
FiguredDrawing joined(const std::vector<ShapeFile>& files, const PackVerbOptions& options) {
    if (files.size() == 1 && !from_meshes(options)) return files.front().drawing();
    std::vector<FiguredDrawing> drawings;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < files.size(); ++i) {
        drawings.push_back(files[i].drawing());
        names.push_back(std::filesystem::path(options.shapes[i]).stem().string());
    }
    return merged_figures(drawings, names);
}

}  // namespace

PackShapes read_pack_shapes(const PackVerbOptions& options) {
    PackShapes shapes;
    const std::vector<ShapeFile> files = read_files(options);
    for (const ShapeFile& file : files)
        shapes.warnings.insert(shapes.warnings.end(), file.input.warnings.begin(), file.input.warnings.end());
    const std::vector<ShapePlace> places = all_shapes(files);
    std::vector<Region> drawn, sulci;
    if (!options.drawn_regions.empty() && !keeps_circles(options))
        drawn = drawn_over(options.drawn_regions, "--regions", places);
    if (!options.sulci.empty()) sulci = drawn_over(options.sulci, "--sulci", places);
    for (std::size_t i = 0; i < places.size(); ++i)
        shapes.shapes.push_back(
            pack_shape(places[i], drawn.empty() ? nullptr : &drawn[i], sulci.empty() ? nullptr : &sulci[i], options));
    shapes.drawing = joined(files, options);
    shapes.meshes = meshes_of(shapes, places, options);
    return shapes;
}

}  // namespace rinceau
