// The rules of drawings grown on meshes: what is laid, what is lost, and whether anything folds or leaves the surface.

#include <filesystem>

#include "growth/surface/curvature_field.h"
#include "growth/surface/field_smooth.h"
#include "growth/surface/grow_drawing.h"
#include "growth/surface/surface_lookup.h"
#include "lsystem/grammar_text.h"
#include "surface_bench.h"
#include "surface_cases.h"
#include "surface_table.h"

namespace rinceau::test {
namespace {

constexpr double most_folded = 0;
constexpr double most_distance = 2.1e-3;  // of the diagonal: all ranks of lift together (LaidMeshOptions)
constexpr double most_lost = 0.08;        // of the elements: dropped because the surface bends too much

/// By the triangles themselves: does one look into the surface that its corners' normals stand on? Share of the area.
double folded_share(const SurfacePattern& pattern) {
    double all = 0, folded = 0;
    for (const NamedMesh& laid : pattern.laid) {
        for (const auto& [a, b, c] : laid.mesh.triangles) {
            const auto at = [&](int v) { return laid.mesh.positions[static_cast<std::size_t>(v)]; };
            const SpacePoint across = cross(at(b) - at(a), at(c) - at(a));
            const auto normal = [&](int v) { return laid.normals[static_cast<std::size_t>(v)]; };
            all += abs(across);
            if (dot(across, normal(a) + normal(b) + normal(c)) < 0) folded += abs(across);
        }
    }
    return all > 0 ? folded / all : 0;
}

/// Largest distance of a laid corner from the surface, share of the diagonal.
double farthest(const SurfacePattern& pattern, const SurfaceMesh& surface) {
    const SurfaceLookup lookup(surface);
    double worst = 0;
    constexpr std::size_t looks = 20'000;
    for (const NamedMesh& laid : pattern.laid) {
        const std::size_t step = laid.mesh.positions.size() / looks + 1;
        for (std::size_t i = 0; i < laid.mesh.positions.size(); i += step)
            worst = std::max(worst, lookup.nearest(laid.mesh.positions[i]).distance);
    }
    return worst / surface.diagonal;
}

void row(GrowthLines& lines, const RowPrinter& rows, const std::string& drawing, const MeshCase& mesh, bool with_field) {
    const Grammar grammar = parse_grammar(file_text(RINCEAU_SAMPLES "/" + drawing + ".lsys"), drawing);
    const SurfaceMesh& surface = *mesh.surface;
    std::optional<FieldOnSurface> field;
    constexpr double radius = 0.1;  // of smoothing
    if (with_field) field.emplace(surface, smoothed(surface, guiding_curvature_field(surface), radius));
    GrownDrawing grown;
    const double seconds = best_seconds(1, [&] { grown = grow_drawing(grammar, surface, field ? &*field : nullptr); });
    const double folded = folded_share(grown.pattern), distance = farthest(grown.pattern, surface);
    const double lost = grown.elements == 0 ? 1 : static_cast<double>(grown.dropped) / static_cast<double>(grown.elements);
    std::string faults;
    if (grown.laid == 0) faults += " empty";
    if (folded > most_folded) faults += " folds";
    if (distance > most_distance) faults += " distance";
    if (lost > most_lost) faults += " dropped";
    if (!grown.pattern.complete) faults += " limit";
    lines.count(faults.empty());
    const auto text = [](long number) { return std::to_string(number); };
    rows.print({drawing, mesh.name, with_field ? "curvature" : "-", text(grown.elements), text(grown.laid),
                text(grown.shrunk), text(grown.split), text(grown.dropped), text(grown.stopped), short_text(seconds),
                short_text(folded), short_text(distance), verdict_of(faults)});
}

}  // namespace

void drawing_rows(GrowthLines& lines, const SurfaceBenchOptions& options, const std::vector<MeshCase>& meshes) {
    if (!options.wants("drawings")) return;
    if (!options.csv) std::cout << "\ndrawings (bars: nothing folds, <= 8 % dropped)\n";
    const RowPrinter rows(options.csv,
                          {"drawing", "mesh", "field", "elements", "laid", "shrunk", "split", "dropped", "stopped",
                           "seconds", "folded", "off surf.", "verdict"},
                          {9, 16, 9, 8, 6, 6, 5, 7, 7, 8, 6, 9});
    constexpr int most_faces = 100'000;
    for (const std::string drawing : {"vine", "mandala", "scales"})
        for (const MeshCase& mesh : meshes)
            for (const bool with_field : {false, true})
                if (mesh.surface && mesh.surface->faces() < most_faces) row(lines, rows, drawing, mesh, with_field);
}

}  // namespace rinceau::test
