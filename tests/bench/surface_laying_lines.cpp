// Outlines laid on surfaces: how many a second, and how many lie only when shrunk, or not at all (bars: docs/growth.md).

#include <cmath>

#include "geometry/angle.h"
#include "geometry/random.h"
#include "growth/surface/lay_triangles.h"
#include "surface_bench.h"
#include "surface_cases.h"

namespace rinceau::test {
namespace {

constexpr int places = 300;
constexpr double margin = 1.05;  // of a chart's radius over the outline's
constexpr double shrunk = 0.6;   // the least that an outline is shrunk to

struct Fan {
    std::vector<Point> points;
    std::vector<std::array<int, 3>> triangles;
    double area = 0;
};

/// A disc of 24 triangles.
Fan disc_of(double radius) {
    constexpr int sides = 24;
    Fan fan;
    fan.points.push_back({0, 0});
    for (int i = 0; i < sides; ++i)
        fan.points.push_back({radius * std::cos(two_pi * i / sides), radius * std::sin(two_pi * i / sides)});
    for (int i = 0; i < sides; ++i) fan.triangles.push_back({0, i + 1, (i + 1) % sides + 1});
    fan.area = sides * radius * radius * std::sin(two_pi / sides) / 2;
    return fan;
}

class DiscLayer {
  public:
    explicit DiscLayer(const SurfaceMesh& surface) : surface_(&surface), maker_(surface) {}

    bool lays(SurfacePoint at, double radius) {
        const DrawingChart chart = drawing_chart(*surface_, maker_.patch(at, {1, 0}, margin * radius));
        const Fan disc = disc_of(radius);
        LaidPieces laid;
        return lay_triangles(*surface_, chart, {disc.points, disc.triangles, disc.area}, {}, visits_, laid) ==
               LayFault::none;
    }

  private:
    const SurfaceMesh* surface_;
    PatchMaker maker_;
    ChartVisits visits_;
};

std::vector<SurfacePoint> places_on(const SurfaceMesh& surface) {
    Random random(17);
    std::vector<SurfacePoint> result;
    for (int i = 0; i < places; ++i) result.push_back(random_surface_point(surface, random));
    return result;
}

void shares(GrowthLines& lines, const std::vector<MeshCase>& meshes, double share, double most) {
    double worst = 0, worst_full = 0;
    for (const MeshCase& mesh : meshes) {
        if (!is_closed(mesh)) continue;
        DiscLayer layer(*mesh.surface);
        const double radius = share * mesh.surface->diagonal;
        int not_full = 0, dropped = 0;
        for (const SurfacePoint at : places_on(*mesh.surface)) {
            if (layer.lays(at, radius)) continue;
            ++not_full;
            dropped += layer.lays(at, shrunk * radius) ? 0 : 1;
        }
        worst = std::max(worst, 100.0 * dropped / places);
        worst_full = std::max(worst_full, 100.0 * not_full / places);
    }
    std::ostringstream name;
    name << "radius " << share << ", worst mesh: ";
    lines.at_most(name.str() + "split or dropped (%)", worst, most);
    lines.say(name.str() + "shrunk, split or dropped", worst_full);
}

void speed(GrowthLines& lines, const MeshCase& mesh) {
    const std::vector<SurfacePoint> at = places_on(*mesh.surface);
    for (const double share : {0.01, 0.02, 0.03}) {
        DiscLayer layer(*mesh.surface);
        const double seconds = best_seconds(3, [&] {
            for (const SurfacePoint place : at) layer.lays(place, share * mesh.surface->diagonal);
        });
        std::ostringstream name;
        name << mesh.name << ", radius " << share << ": laid a second";
        lines.at_least(name.str(), places / seconds, 5000);
    }
}

}  // namespace

void laying_lines(GrowthLines& lines, const SurfaceBenchOptions& options, const std::vector<MeshCase>& meshes) {
    if (!options.wants("outlines")) return;
    lines.begin("outlines laid on closed surfaces, 300 places each");
    shares(lines, meshes, 0.01, 0.5);
    shares(lines, meshes, 0.02, 2);
    shares(lines, meshes, 0.04, 8);
    for (const MeshCase& mesh : meshes)
        if (mesh.name == "cub" || mesh.name == "bunny_adaptive") speed(lines, mesh);
}

}  // namespace rinceau::test
