// Moves along fields: how many a second, how exact (bars: docs/growth.md, "Patterns on surfaces").

#include <cmath>

#include "../surface/surface_shapes.h"
#include "growth/surface/trace.h"
#include "surface_bench.h"
#include "surface_cases.h"

namespace rinceau::test {
namespace {

constexpr int walks = 20000;

struct Start {
    SurfacePoint at;
    Complex direction;
};

std::vector<Start> starts_on(const SurfaceMesh& surface, int count) {
    Random random(11);
    std::vector<Start> starts;
    for (int i = 0; i < count; ++i) {
        const SurfacePoint at = random_surface_point(surface, random);
        const double angle = random.uniform(0, two_pi);
        starts.push_back({at, {std::cos(angle), std::sin(angle)}});
    }
    return starts;
}

/// No singular face is within two rings of faces about this one.
std::vector<bool> calm_faces(const FieldOnSurface& field) {
    const SurfaceMesh& surface = field.surface();
    std::vector<bool> near_vertex(static_cast<std::size_t>(surface.vertices()), false);
    std::vector<bool> calm(static_cast<std::size_t>(surface.faces()), true);
    for (const int face : field.singular_faces()) calm[static_cast<std::size_t>(face)] = false;
    constexpr int rings = 2;
    for (int ring = 0; ring < rings; ++ring) {
        for (std::size_t f = 0; f < calm.size(); ++f)
            if (!calm[f])
                for (const int v : surface.mesh.triangles[f]) near_vertex[static_cast<std::size_t>(v)] = true;
        for (std::size_t f = 0; f < calm.size(); ++f)
            for (const int v : surface.mesh.triangles[f])
                if (near_vertex[static_cast<std::size_t>(v)]) calm[f] = false;
    }
    return calm;
}

void speed_and_angle(GrowthLines& lines, const std::string& name, const SurfaceMesh& surface, const FieldOnSurface& field) {
    const std::vector<Start> starts = starts_on(surface, walks);
    double seconds = best_seconds(3, [&] {
        for (const Start& start : starts) trace(surface, &field, start.at, start.direction, surface.mean_edge);
    });
    lines.begin("walks, " + name + ", " + std::to_string(surface.faces()) + " faces");
    lines.at_least("moves a second, one mean edge long", walks / seconds, 400e3);

    constexpr double edges = 3, most_degrees = 2;
    const std::vector<bool> calm = calm_faces(field);
    double sum = 0, worst = 0;
    long samples = 0, far = 0, counted = 0;
    for (const Start& start : starts) {
        if (!calm[static_cast<std::size_t>(start.at.face)]) continue;
        const SurfaceTrace walk = trace(surface, &field, start.at, start.direction, edges * surface.mean_edge);
        if (walk.jumps > 0) continue;
        sum += walk.angle_error_sum;
        samples += walk.angle_samples;
        worst = std::max(worst, walk.angle_error);
        far += walk.angle_error * degrees_per_radian > most_degrees ? 1 : 0;
        ++counted;
    }
    lines.at_most("angle to the field, mean (degrees)",
                  samples == 0 ? 0 : sum / static_cast<double>(samples) * degrees_per_radian, 0.1);
    lines.say("angle to the field, largest (degrees)", worst * degrees_per_radian);
    lines.at_most("share of three-edge walks above 2 degrees",
                  counted == 0 ? 0 : static_cast<double>(far) / static_cast<double>(counted), 1e-3);
}

/// A loxodrome climbs evenly: latitude = distance * sin(angle), longitude by Mercator's stretch.
void loxodrome(GrowthLines& lines) {
    const SurfaceMesh sphere = surface_mesh(sphere_triangles(5));
    const FieldOnSurface east(sphere, field_of_vectors(sphere, [](SpacePoint p) { return SpacePoint{-p.y, p.x, 0}; }));
    constexpr double length = 0.8;
    double worst = 0;
    for (int k = 0; k < 24; ++k) {
        const double angle = radians(15.0 * k + 4);
        const SpacePoint from = unit({std::cos(0.7 * k), std::sin(0.7 * k), 0.15});
        const SurfacePoint at = nearest_point(sphere, from);
        const SpacePoint start = unit(position_in_space(sphere, at));
        const Complex along = root_near(east.at(at), 1, {1, 0});
        const SurfaceTrace walk = trace(sphere, &east, at, along * Complex{std::cos(angle), std::sin(angle)}, length);
        const double low = std::asin(start.z), high = low + length * std::sin(angle);
        const auto mercator = [](double latitude) { return std::asinh(std::tan(latitude)); };
        const double turned = std::abs(std::sin(angle)) < 1e-9 ? length / std::cos(low)
                                                              : (mercator(high) - mercator(low)) / std::tan(angle);
        const double longitude = std::atan2(start.y, start.x) + turned;
        const SpacePoint end{std::cos(high) * std::cos(longitude), std::cos(high) * std::sin(longitude), std::sin(high)};
        worst = std::max(worst, abs(unit(position_in_space(sphere, walk.end)) - end));
    }
    lines.begin("walks, loxodromes on a sphere of 20,480 faces");
    lines.at_most("end, largest distance from the closed form", worst, 3e-4 * 2);
}

}  // namespace

void walk_lines(GrowthLines& lines, const SurfaceBenchOptions& options) {
    if (!options.wants("walks")) return;
    loxodrome(lines);
    for (const MeshCase& one : mesh_cases(options)) speed_and_angle(lines, one.name, one.surface, smoothest(one.surface));
}

}  // namespace rinceau::test
