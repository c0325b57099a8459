// Patterns of the sizes that the paper's table 1 has: seconds and bytes (bars: docs/growth.md, "Patterns on surfaces").

#include <cmath>

#include "tests/surface/surface_shapes.h"
#include "growth/mesh/mesh_glb_write.h"
#include "growth/surface/derive_shapes.h"
#include "growth/surface/parse_shape_grammar.h"
#include "lsystem/expression.h"
#include "surface_bench.h"
#include "surface_cases.h"

namespace rinceau::test {
namespace {

struct Grown {
    SurfaceWorld world;
    SurfacePattern pattern;
    double seconds = 0;  ///< of the derivation
};

/// A grammar of samples/surface with other params.
Grown grown(const std::string& name, const std::vector<std::pair<std::string, double>>& params,
            const std::shared_ptr<const SurfaceMesh>& surface) {
    const std::string folder = RINCEAU_SAMPLES "/surface/";
    std::vector<std::pair<std::string, Expression>> values;
    for (const auto& [param, value] : params) values.emplace_back(param, number_expression(value));
    const ShapeGrammar grammar = with_params(parse_shape_grammar(file_text(folder + name), name), values);
    Grown result;
    result.world = make_world(grammar, surface, [&](const std::string& file) { return file_text(folder + file); });
    const ShapeDerivationOptions options = options_of(grammar);
    result.seconds = best_seconds(3, [&] { result.pattern = derive_shapes(grammar, result.world, options); });
    return result;
}

/// Figure 17: 40,000 faces in, 4 million out.
void tile_lines(GrowthLines& lines) {
    constexpr int around = 168, along = 120;
    const auto torus = std::make_shared<const SurfaceMesh>(surface_mesh(torus_triangles(around, along, 1, 0.45)));
    // Rings of 576 faces each, as many as fit at this half edge of the honeycomb.
    constexpr double half_edge = 0.006;
    const Grown tile = grown("rings_a.fgsg", {{"d", half_edge * torus->diagonal}}, torus);
    const MeshAssembly assembly = assembly_of(tile.pattern, *torus, {.with_surface = true});
    lines.begin("sizes, tile (rings_a) on a torus of 40,320 faces");
    lines.at_least("faces out", static_cast<double>(faces_out(assembly)), 4e6);
    lines.at_most("seconds (paper, figure 17: 12)", tile.seconds, 0.2);
    std::string bytes;
    const double seconds = best_seconds(2, [&] { bytes = glb_bytes(assembly, {.instancing = GlbInstancing::gpu}); });
    lines.at_most("GLB with instances, megabytes", static_cast<double>(bytes.size()) / 1e6, 2);
    lines.say("GLB, seconds", seconds);
}

void pattern_lines(GrowthLines& lines, const MeshCase& mesh, const std::string& pattern, const std::string& paper,
                   double most_seconds) {
    const Grown result = grown(pattern + ".fgsg", {}, mesh.surface);
    lines.begin("sizes, " + pattern + " on " + mesh.name + " of " + std::to_string(mesh.surface->faces()) + " faces");
    lines.say("shapes and lines", static_cast<double>(result.pattern.placed.size() + result.pattern.lines.size()));
    lines.say("translations", static_cast<double>(result.pattern.counts.translations));
    lines.say("faces out", static_cast<double>(faces_out(assembly_of(result.pattern, *mesh.surface))));
    lines.at_most("seconds (paper, " + paper + ")", result.seconds, most_seconds);
}

}  // namespace

void size_lines(GrowthLines& lines, const SurfaceBenchOptions& options, const std::vector<MeshCase>& meshes) {
    if (!options.wants("sizes")) return;
    tile_lines(lines);
    // The bunny is the surface of the paper's figures 1 and 13 b; without it a mesh of our own of as many faces.
    const auto named = [&](const std::string& name) {
        return std::find_if(meshes.begin(), meshes.end(), [&](const MeshCase& one) { return one.name == name; });
    };
    const auto bunny = named("bunny_adaptive"), own = named("cub");
    const auto mesh = bunny != meshes.end() && bunny->surface ? bunny : own;
    if (mesh == meshes.end() || !mesh->surface) return lines.failed("no mesh to grow on");
    pattern_lines(lines, *mesh, "vine", "figure 13 b: 1", 0.2);
    pattern_lines(lines, *mesh, "cracks", "figure 1: 182", 0.4);
}

}  // namespace rinceau::test
