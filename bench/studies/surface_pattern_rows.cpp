// A row for each of the paper's patterns on each mesh (bars: docs/growth.md, "Patterns on surfaces").

#include <cmath>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>

#include "geometry/angle.h"
#include "growth/mesh/mesh_picture.h"
#include "growth/surface/derive_shapes.h"
#include "growth/surface/measure_pattern.h"
#include "growth/surface/parse_shape_grammar.h"
#include "scene/svg_raster.h"
#include "surface_bench.h"
#include "surface_cases.h"
#include "surface_table.h"

namespace rinceau::test {
namespace {

constexpr double most_degrees = 0.1;    // of the angle to the field, mean
constexpr double most_distance = 1e-6;  // of a foot from the surface, share of the diagonal

/// A row of the paper's table 1.
struct PaperRow {
    const char* figure;
    double seconds;
};

struct PatternCase {
    std::string file;     ///< in samples/surface, without its ending
    std::string meshes;   ///< names between blanks; empty = all
    double most_seconds;  ///< of the processor, for the derivation alone
    std::optional<PaperRow> paper;
};

/// Bars: those that docs/growth.md names, else the paper's seconds.
const std::vector<PatternCase>& pattern_cases() {
    static const std::vector<PatternCase> cases{
        {"vine", "", 0.5, PaperRow{"13 b", 1}},
        {"stars", "", 9, PaperRow{"14 a", 9}},
        {"cracks", "", 0.4, PaperRow{"15 a", 15}},
        {"radial", "", 1, PaperRow{"15 b", 1}},
        {"tree", " vase blob sphere ", 13, PaperRow{"15 c", 13}},
        {"tiles", "", 10, PaperRow{"16 a", 10}},
        {"rings_a", " three_rings torus ", 12, std::nullopt},
        {"rings_b", " three_rings torus ", 12, PaperRow{"17", 12}},
        {"places", " cub vase ", 3, PaperRow{"19", 3}},
        {"glyphs", "", 10, std::nullopt},
        {"tile", " plane ", 10, std::nullopt},
        {"merging", " plane ", 10, std::nullopt},
        {"mosaic", " plane ", 10, std::nullopt},
    };
    return cases;
}

bool is_for(const PatternCase& one, const std::string& mesh) {
    return mesh == "plane" || !one.meshes.empty() ? one.meshes.find(' ' + mesh + ' ') != std::string::npos : true;
}

struct GrownCase {
    SurfaceWorld world;
    SurfacePattern pattern;
    PatternMeasures measures;
    double world_seconds = 0, seconds = 0;
    long faces = 0;
};

GrownCase grown(const PatternCase& one, const std::shared_ptr<const SurfaceMesh>& surface) {
    const std::filesystem::path folder = RINCEAU_SAMPLES "/surface";
    const std::string file = (folder / (one.file + ".fgsg")).string();
    const ShapeGrammar grammar = parse_shape_grammar(file_text(file), file);
    GrownCase result;
    result.world_seconds = best_seconds(1, [&] {
        result.world =
            make_world(grammar, surface, [&](const std::string& name) { return file_text((folder / name).string()); });
    });
    const ShapeDerivationOptions options = options_of(grammar);
    result.seconds = best_seconds(2, [&] { result.pattern = derive_shapes(grammar, result.world, options); });
    result.measures = measure_pattern(result.pattern, *result.world.surface, {.touch = options.touch, .kin = options.kin});
    return result;
}

/// The sum of the first field's indices against the Euler characteristic; none for surfaces with a border.
std::optional<double> index_sum(const SurfaceWorld& world) {
    if (world.fields.empty() || world.surface->border_edges > 0) return std::nullopt;
    const FieldOnSurface& field = *world.fields.front().field;
    return static_cast<double>(field.index_sum()) / field.n();
}

std::string faults_of(const PatternCase& one, const GrownCase& grown, double angle_mean) {
    std::string faults;
    const auto expect = [&](bool good, const char* what) { faults += good ? "" : std::string(" ") + what; };
    expect(grown.pattern.complete, "limit");
    expect(grown.seconds <= one.most_seconds, "seconds");
    expect(angle_mean <= most_degrees, "angle");
    expect(grown.measures.surface_distance_max <= most_distance, "distance");
    expect(grown.measures.overlaps == 0 && grown.measures.complete, "overlaps");
    const std::optional<double> index = index_sum(grown.world);
    expect(!index || *index == euler_characteristic(*grown.world.surface), "index");
    expect(!grown.pattern.placed.empty() || !grown.pattern.lines.empty(), "empty");
    return faults;
}

void draw(const SurfaceBenchOptions& options, const std::string& name, const MeshAssembly& assembly) {
    if (options.pictures.empty()) return;
    std::filesystem::create_directories(options.pictures);
    constexpr int width = 600;
    const Picture picture = mesh_picture(assembly, UpAxis::y, {.elevation = 0.35, .width = width});
    std::ofstream(std::filesystem::path(options.pictures) / (name + ".png"), std::ios::binary) << picture_to_png(picture);
}

void row(GrowthLines& lines, const SurfaceBenchOptions& options, const RowPrinter& rows, const PatternCase& one,
         const std::string& mesh, const std::shared_ptr<const SurfaceMesh>& surface) {
    const GrownCase result = grown(one, surface);
    const SurfaceMesh& ground = *result.world.surface;
    const MeshAssembly assembly = assembly_of(result.pattern, ground, {.with_surface = true});
    const PatternCounts& counts = result.pattern.counts;
    const double mean =
        counts.angle_samples == 0 ? 0 : degrees(counts.angle_error_sum / static_cast<double>(counts.angle_samples));
    const std::optional<double> index = index_sum(result.world);
    const std::string faults = faults_of(one, result, mean);
    lines.count(faults.empty());
    rows.print({one.file, mesh, std::to_string(result.pattern.placed.size() + result.pattern.lines.size()),
                std::to_string(faces_out(assembly)), short_text(result.world_seconds), short_text(result.seconds),
                one.paper ? short_text(one.paper->seconds) : "-", short_text(mean),
                short_text(degrees(counts.angle_error_max)), short_text(result.measures.surface_distance_max),
                std::to_string(result.measures.overlaps), index ? short_text(*index) : "-",
                std::to_string(euler_characteristic(ground)), verdict_of(faults)});
    draw(options, one.file + "_" + mesh, assembly);
}

void guarded_row(GrowthLines& lines, const SurfaceBenchOptions& options, const RowPrinter& rows, const PatternCase& one,
                 const std::string& mesh, const std::shared_ptr<const SurfaceMesh>& surface) {
    try {
        row(lines, options, rows, one, mesh, surface);
    } catch (const std::exception& error) {
        lines.failed(one.file + " on " + mesh + ": " + error.what());
    }
}

}  // namespace

void pattern_rows(GrowthLines& lines, const SurfaceBenchOptions& options, const std::vector<MeshCase>& meshes) {
    if (!options.wants("patterns")) return;
    if (!options.csv) std::cout << "\npatterns (angles in degrees; seconds of the processor)\n";
    const RowPrinter rows(options.csv,
                          {"pattern", "mesh", "shapes", "faces", "field s", "grow s", "paper s", "angle mean", "angle max",
                           "off surf.", "overlaps", "index", "Euler", "verdict"},
                          {9, 16, 8, 9, 8, 8, 8, 11, 11, 10, 9, 7, 6});
    for (const PatternCase& one : pattern_cases()) {
        if (is_for(one, "plane")) guarded_row(lines, options, rows, one, "plane", nullptr);
        for (const MeshCase& mesh : meshes)
            if (mesh.surface && is_for(one, mesh.name)) guarded_row(lines, options, rows, one, mesh.name, mesh.surface);
    }
}

}  // namespace rinceau::test
