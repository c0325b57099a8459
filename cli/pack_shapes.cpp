// Each shape stands upright in the frame of its exclusive region: as its first whole copy stands in the drawing, so that angle 0
// and scale 1 mean what a person sees there, wherever the analysis has put the terminal's own heading.

#include "cli/pack_shapes.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "analyzer/analyze.h"
#include "growth/merge_figures.h"
#include "growth/mesh/mesh_obj_read.h"
#include "growth/mesh/mesh_silhouette.h"
#include "growth/strokes.h"
#include "scene/svg_read.h"

namespace rinceau {
namespace {

/// How near outlines of shapes are followed, as a share of the drawing.
constexpr double deviation_share = 5e-4;

/// A file with shapes, and how to get from each figure to the file's plane.
struct ShapeFile {
    std::string label;
    FiguredDrawing drawing;
    std::vector<Similarity> drawn;  ///< figure -> scene, of its first whole instance
    std::optional<TriangleMesh> mesh;
};

std::vector<std::string> messages(const std::vector<Warning>& warnings) {
    std::vector<std::string> list;
    for (const Warning& warning : warnings) list.push_back(located(warning.place, warning.message));
    return list;
}

void append(std::vector<std::string>& list, const std::vector<std::string>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

void expect_figures(const ShapeFile& file) {
    if (file.drawing.figures.empty()) throw InputError({file.label}, "expected shapes that enclose an area, found none");
}

ShapeFile figures_of_scene(const Scene& scene, const std::string& label, const FigureOptions& figure_options, int threads,
                           const Progress& progress) {
    AnalyzeOptions analysis;
    analysis.threads = threads;
    ShapeFile file{.label = label, .drawing = figures_of(analyze(scene, analysis, progress).grammar, figure_options, progress)};
    expect_figures(file);
    for (std::size_t i = 0; i < file.drawing.figures.size(); ++i) {
        const auto is_copy = [i](const FigureInstance& instance) {
            return instance.whole && instance.figure == static_cast<int>(i);
        };
        const auto first = std::ranges::find_if(file.drawing.instances, is_copy);
        file.drawn.push_back(first == file.drawing.instances.end() ? Similarity{} : first->pose);
    }
    return file;
}

Scene read_scene(const std::string& name, std::vector<std::string>& warnings) {
    const SvgReadResult read = read_svg(read_input(name), {.file_name = input_label(name)});
    append(warnings, messages(read.warnings));
    return read.scene;
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

std::vector<ShapeFile> read_files(const PackVerbOptions& options, std::vector<std::string>& warnings, const Progress& progress) {
    FigureOptions figure_options{.raised = options.raised};
    figure_options.one_figure = options.shapes.size() > 1 || from_meshes(options);
    std::vector<ShapeFile> files;
    for (const std::string& name : options.shapes) {
        const std::string label = input_label(name);
        std::optional<TriangleMesh> mesh;
        if (from_meshes(options)) mesh = read_mesh(name);
        const Scene scene = mesh ? silhouette_scene(*mesh, options.up, label, mesh_color(files.size())) : read_scene(name, warnings);
        files.push_back(figures_of_scene(scene, label, figure_options, options.threads, progress));
        files.back().mesh = std::move(mesh);
        append(warnings, files.back().drawing.warnings);
    }
    return files;
}

/// A shape that is known by its file and its number there.
struct ShapePlace {
    const ShapeFile* file = nullptr;
    std::size_t figure = 0;

    const Figure& shape() const { return file->drawing.figures[figure]; }
    Similarity drawn() const { return file->drawn[figure]; }
    /// For messages: the file, and the symbol if it has several shapes.
    std::string label() const {
        return file->drawing.figures.size() > 1 ? file->label + ", shape " + shape().symbol : file->label;
    }
};

std::vector<ShapePlace> all_shapes(const std::vector<ShapeFile>& files) {
    std::vector<ShapePlace> places;
    for (const ShapeFile& file : files)
        for (std::size_t i = 0; i < file.drawing.figures.size(); ++i) places.push_back({&file, i});
    return places;
}

Region moved(const Similarity& pose, Region region) {
    for (std::vector<Point>& ring : region)
        for (Point& p : ring) p = apply(pose, p);
    return region;
}

/// What `option` draws over the shapes, in the shapes' order and in the scenes of their files: an outline for each element of a
/// drawing that holds as many as there are shapes, or a whole drawing for each shape.
std::vector<Region> drawn_over(const std::vector<std::string>& names, const std::string& option,
                               const std::vector<ShapePlace>& shapes, std::vector<std::string>& warnings) {
    std::vector<Region> regions;
    for (const std::string& name : names) {
        Scene scene = read_scene(name, warnings);
        const double deviation = deviation_share * drawing_diagonal(scene);
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
            throw InputError({label}, option + ": outline " + std::to_string(i + 1) + " is not drawn over " + shapes[i].label());
    return regions;
}

/// Turned, scaled and mirrored as it is drawn, about the figure's own origin.
Similarity upright(const ShapePlace& shape) { return {shape.drawn().linear, {}, shape.drawn().mirrored}; }

/// From the plane of the file to upright(): a move.
Similarity to_upright(const ShapePlace& shape) { return translate(-shape.drawn().translation); }

PackShape pack_shape(const ShapePlace& place, const Region* drawn, const Region* sulcus, const PackVerbOptions& options) {
    PackShape shape;
    const Region outline = moved(upright(place), place.shape().outline);
    shape.region = drawn != nullptr
                       ? drawn_exclusive_region(moved(to_upright(place), *drawn), options.exclusive, place.label())
                       : exclusive_region(outline, options.exclusive, place.label());
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
    const Point3 foot = up == UpAxis::y ? Point3{middle.x, low.y, -middle.y} : Point3{middle.x, middle.y, low.z};
    const Point3 to = up == UpAxis::y ? Point3{at.x, 0, -at.y} : Point3{at.x, at.y, 0};
    for (Point3& p : mesh.positions) p = scale * (p - foot) + to;
    return mesh;
}

Box ground_box(const TriangleMesh& mesh, UpAxis up) {
    Box box;
    for (const Point3 p : mesh.positions) box = including(box, ground_point(p, up));
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
        const int number = part.style != 0 ? part.style : drawing.grammar.terminals[static_cast<std::size_t>(part.terminal)].style;
        const auto style = std::ranges::find(drawing.grammar.styles, number, &NumberedStyle::number);
        if (style == drawing.grammar.styles.end()) continue;
        if (const Color* color = std::get_if<Color>(&style->style.fill)) return *color;
    }
    return NamedMesh{}.color;
}

std::vector<NamedMesh> meshes_of(const PackShapes& shapes, const std::vector<ShapePlace>& places, const PackVerbOptions& options) {
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
FiguredDrawing joined(std::vector<ShapeFile>& files, const PackVerbOptions& options) {
    if (files.size() == 1 && !from_meshes(options)) return files.front().drawing;
    std::vector<FiguredDrawing> drawings;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < files.size(); ++i) {
        drawings.push_back(files[i].drawing);
        names.push_back(std::filesystem::path(options.shapes[i]).stem().string());
    }
    return merged_figures(drawings, names);
}

}  // namespace

PackShapes read_pack_shapes(const PackVerbOptions& options, const Progress& progress) {
    PackShapes shapes;
    std::vector<ShapeFile> files = read_files(options, shapes.warnings, progress);
    const std::vector<ShapePlace> places = all_shapes(files);
    std::vector<Region> drawn, sulci;
    if (!options.drawn_regions.empty()) drawn = drawn_over(options.drawn_regions, "--regions", places, shapes.warnings);
    if (!options.sulci.empty()) sulci = drawn_over(options.sulci, "--sulci", places, shapes.warnings);
    for (std::size_t i = 0; i < places.size(); ++i)
        shapes.shapes.push_back(
            pack_shape(places[i], drawn.empty() ? nullptr : &drawn[i], sulci.empty() ? nullptr : &sulci[i], options));
    shapes.drawing = joined(files, options);
    shapes.meshes = meshes_of(shapes, places, options);
    return shapes;
}

}  // namespace rinceau
