#include "editor/model/surface_stage.h"

#include "growth/surface/surface_read.h"

namespace rinceau {
namespace {

std::string counted(long count, const std::string& one, const std::string& many) {
    std::string digits = std::to_string(count);
    for (int i = static_cast<int>(digits.size()) - 3; i > 0; i -= 3) digits.insert(static_cast<std::size_t>(i), ",");
    return digits + ' ' + (count == 1 ? one : many);
}

/// Closed surfaces of one part have a genus.
std::string shape_in_words(const SurfaceMesh& surface) {
    if (surface.border_edges > 0) return counted(surface.border_edges, "edge", "edges") + " of its border";
    return "closed, Euler characteristic " + std::to_string(euler_characteristic(surface));
}

}  // namespace

SurfaceStage surface_stage(const std::string& path, const std::string& text) {
    constexpr Color clay{214, 208, 196};
    SurfaceReading reading = read_surface(text, path);
    SurfaceStage stage{.path = path};
    for (const Warning& warning : reading.warnings) stage.warnings.push_back(located(warning.place, warning.message));
    MeshAssembly ground;
    ground.meshes.push_back({"surface", reading.surface.mesh, clay});
    ground.instances.push_back({0, {}});
    stage.ground = std::make_shared<const MeshAssembly>(std::move(ground));
    stage.told = counted(reading.surface.faces(), "face", "faces") + ", " + shape_in_words(reading.surface);
    stage.surface = std::make_shared<const SurfaceMesh>(std::move(reading.surface));
    return stage;
}

StageField stage_field(const SurfaceStage&, const FieldSettings&, double, const Progress&) { return {}; }
GrownSurface grown_on_surface(const SurfaceOrder&, const ReadNamed&, const SurfaceWatch&) { return {}; }

}  // namespace rinceau
