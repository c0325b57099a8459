// Moves along fields: how many a second, how exact (bars: docs/growth.md, "Patterns on surfaces").

#include <cmath>

#include "tests/surface/surface_shapes.h"
#include "growth/surface/curvature_field.h"
#include "growth/surface/field_elements.h"
#include "growth/surface/field_smooth.h"
#include "growth/surface/trace.h"
#include "surface_bench.h"
#include "surface_cases.h"

namespace rinceau::test {
namespace {

constexpr int walks = 10000;
constexpr double in_degrees = 180 / pi;

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

void speed_line(GrowthLines& lines, const SurfaceMesh& surface, const FieldOnSurface& field) {
    constexpr int moves = 4000, times = 6;
    const std::vector<Start> starts = starts_on(surface, moves);
    const double seconds = best_seconds(times, [&] {
        for (const Start& start : starts) trace(surface, &field, start.at, start.direction, surface.mean_edge);
    });
    lines.at_least("moves a second, one mean edge long", moves / seconds, 400e3);
}

/// Three-edge walks clear of singular faces by two rings: all, and those that are off by more than 2 degrees somewhere.
struct LongWalks {
    long all = 0, far = 0;
};

LongWalks angle_lines(GrowthLines& lines, const SurfaceMesh& surface, const FieldOnSurface& field) {
    constexpr double edges = 3, most_degrees = 2;
    const std::vector<bool> calm = calm_faces(field);
    double sum = 0, worst = 0;
    long samples = 0;
    LongWalks walked;
    for (const Start& start : starts_on(surface, walks)) {
        if (!calm[static_cast<std::size_t>(start.at.face)]) continue;
        const SurfaceTrace walk =
            trace(surface, &field, start.at, start.direction, edges * surface.mean_edge, {.keep_path = true});
        const auto stays_calm = [&](SurfacePoint p) { return calm[static_cast<std::size_t>(p.face)]; };
        if (!std::all_of(walk.path.begin(), walk.path.end(), stays_calm)) continue;
        sum += walk.angle_error_sum;
        samples += walk.angle_samples;
        worst = std::max(worst, walk.angle_error);
        walked.far += walk.angle_error * in_degrees > most_degrees ? 1 : 0;
        ++walked.all;
    }
    lines.at_most("angle to the field, mean (degrees)", samples == 0 ? 0 : sum / static_cast<double>(samples) * in_degrees,
                  0.1);
    lines.say("angle to the field, largest (degrees)", worst * in_degrees);
    lines.say("of 1,000 three-edge walks above 2 degrees",
              walked.all == 0 ? 0 : 1e3 * static_cast<double>(walked.far) / static_cast<double>(walked.all));
    return walked;
}

FieldOnSurface east_field(const SurfaceMesh& sphere) {
    SurfaceField east{.n = 1};
    for (int v = 0; v < sphere.vertices(); ++v) {
        const SpacePoint p = sphere.mesh.positions[static_cast<std::size_t>(v)];
        const double angle = direction_at_vertex(sphere, v, {-p.y, p.x, 0});
        east.values.push_back({std::cos(angle), std::sin(angle)});
    }
    return {sphere, std::move(east)};
}

/// Where a loxodrome from `start` (on the unit sphere) at `angle` to the east ends: the latitude climbs evenly, the
/// longitude goes by Mercator's stretch.
SpacePoint end_of_loxodrome(SpacePoint start, double angle, double length) {
    const auto mercator = [](double latitude) { return std::asinh(std::tan(latitude)); };
    const double low = std::asin(start.z), high = low + length * std::sin(angle);
    const double longitude = std::atan2(start.y, start.x) + (mercator(high) - mercator(low)) / std::tan(angle);
    return {std::cos(high) * std::cos(longitude), std::cos(high) * std::sin(longitude), std::sin(high)};
}

void loxodrome_lines(GrowthLines& lines) {
    constexpr double length = 0.8;
    constexpr int count = 24;
    const SurfaceMesh sphere = surface_mesh(sphere_triangles(5));
    const FieldOnSurface east = east_field(sphere);
    double worst = 0;
    for (int k = 0; k < count; ++k) {
        const double angle = radians(360.0 / count * (k + 0.5));
        const int vertex = nearest_vertex(sphere, {std::cos(0.7 * k), std::sin(0.7 * k), 0.15});
        const SurfacePoint at = at_vertex(sphere, vertex);
        const Complex along = root_near(east.at(at), 1, {1, 0});
        const SurfaceTrace walk = trace(sphere, &east, at, along * Complex{std::cos(angle), std::sin(angle)}, length);
        const SpacePoint end = end_of_loxodrome(position_in_space(sphere, at), angle, length);
        worst = std::max(worst, abs(unit(position_in_space(sphere, walk.end)) - end));
    }
    lines.begin("walks, loxodromes on a sphere of 20,480 faces");
    lines.at_most("end, largest distance from the closed form", worst, 3e-4);
}

/// A surface that bends alike in all directions has no direction of its own: what its curvature shows is noise.
bool has_directions(const SurfaceField& curvature) {
    constexpr double least = 0.05;  // of the mean curvature
    double directed = 0, mean = 0;
    for (std::size_t v = 0; v < curvature.values.size(); ++v) {
        directed += abs(curvature.values[v]);
        mean += std::abs(curvature.isotropic[v]);
    }
    return directed > least * mean;
}

}  // namespace

void walk_lines(GrowthLines& lines, const SurfaceBenchOptions& options, const std::vector<MeshCase>& meshes) {
    if (!options.wants("walks")) return;
    loxodrome_lines(lines);
    LongWalks walked;
    for (const MeshCase& one : meshes) {
        constexpr int most_faces = 100'000;  // smoothest fields of larger meshes take too long
        if (!one.surface || one.surface->faces() > most_faces) continue;
        const SurfaceMesh& surface = *one.surface;
        const auto measure = [&](const std::string& kind, const FieldOnSurface& field) {
            lines.begin("walks, " + one.name + " (" + std::to_string(surface.faces()) + " faces), " + kind);
            speed_line(lines, surface, field);
            const LongWalks more = angle_lines(lines, surface, field);
            walked.all += more.all;
            walked.far += more.far;
        };
        constexpr double radius = 0.1;
        if (has_directions(curvature_field(surface)))
            measure("curvature", {surface, smoothed(surface, guiding_curvature_field(surface), radius)});
        measure("smoothest", {surface, smoothest_field(surface, 2)});
    }
    lines.begin("walks, " + std::to_string(walked.all) + " of three edges on all meshes");
    lines.at_most("of 1,000 above 2 degrees",
                  walked.all == 0 ? 0 : 1e3 * static_cast<double>(walked.far) / static_cast<double>(walked.all), 1);
}

}  // namespace rinceau::test
