// Polar maps against closed forms (bars: docs/growth.md, "Patterns on surfaces").

#include <cmath>

#include "tests/surface/surface_shapes.h"
#include "growth/surface/polar_map.h"
#include "surface_bench.h"

namespace rinceau::test {
namespace {

struct MapError {
    double distance = 0, position = 0;  ///< root mean squares
    double seconds = 0;
    std::size_t vertices = 0;
};

/// `exact(place)`: the true position of a vertex in the plane of the map, relative to the map's angles.
template <class Exact>
MapError error_of(const SurfaceMesh& surface, int source, double radius, const Exact& exact) {
    MapError error;
    PolarMap map;
    error.seconds = best_seconds(3, [&] { map = polar_map_of_vertex(surface, source, radius); });
    // The frame of a vertex is turned against that of the closed form by one angle, the mean of all differences.
    Complex turn{0, 0};
    for (std::size_t i = 0; i < map.vertices.size(); ++i) {
        const Complex place = exact(surface.mesh.positions[static_cast<std::size_t>(map.vertices[i])]);
        turn =
            turn + place * conj(Complex{map.distance[i] * std::cos(map.angle[i]), map.distance[i] * std::sin(map.angle[i])});
    }
    turn = (1 / abs(turn)) * turn;
    double distance = 0, position = 0;
    for (std::size_t i = 0; i < map.vertices.size(); ++i) {
        const Complex place = exact(surface.mesh.positions[static_cast<std::size_t>(map.vertices[i])]);
        const Complex found =
            turn * Complex{map.distance[i] * std::cos(map.angle[i]), map.distance[i] * std::sin(map.angle[i])};
        distance += (map.distance[i] - abs(place)) * (map.distance[i] - abs(place));
        const Complex apart = found - place;
        position += dot(apart, apart);
    }
    error.vertices = map.vertices.size();
    const double count = std::max<double>(1, static_cast<double>(error.vertices));
    error.distance = std::sqrt(distance / count) / radius;
    error.position = std::sqrt(position / count) / radius;
    return error;
}

/// About the pole of the unit sphere that is the first vertex: distance is the arc, the angle that about the axis.
Complex on_sphere(SpacePoint p, SpacePoint pole) {
    const SpacePoint x = unit(cross(std::abs(pole.z) < 0.9 ? SpacePoint{0, 0, 1} : SpacePoint{1, 0, 0}, pole));
    const SpacePoint y = cross(pole, x);
    const double arc = std::acos(std::clamp(dot(p, pole), -1.0, 1.0));
    const double angle = std::atan2(dot(p, y), dot(p, x));
    return {arc * std::cos(angle), arc * std::sin(angle)};
}

void sphere_lines(GrowthLines& lines) {
    const SurfaceMesh sphere = surface_mesh(sphere_triangles(5));
    const SpacePoint pole = sphere.mesh.positions[0];
    const MapError error = error_of(sphere, 0, 2, [&](SpacePoint p) { return on_sphere(p, pole); });
    lines.begin("polar map, sphere of 20,480 faces, radius 2");
    lines.at_most("distance, rms over radius", error.distance, 1.5e-3);
    lines.at_most("position, rms over radius", error.position, 5e-3);
    lines.say("milliseconds", 1e3 * error.seconds);
}

void cylinder_lines(GrowthLines& lines) {
    constexpr int around = 100, along = 100;
    constexpr double radius = 1, height = 6;
    const SurfaceMesh cylinder = surface_mesh(cylinder_triangles(around, along, radius, height));
    const int source = along / 2 * around;
    const SpacePoint from = cylinder.mesh.positions[static_cast<std::size_t>(source)];
    const MapError error = error_of(cylinder, source, 2, [&](SpacePoint p) {
        return Complex{radius * std::remainder(std::atan2(p.y, p.x) - std::atan2(from.y, from.x), two_pi), p.z - from.z};
    });
    lines.begin("polar map, cylinder of 20,000 faces, radius 2");
    lines.at_most("distance, rms over radius", error.distance, 1e-4);
    lines.say("position, rms over radius", error.position);
    lines.say("milliseconds", 1e3 * error.seconds);
}

void plane_lines(GrowthLines& lines) {
    constexpr int side = 100;
    const SurfaceMesh plane = surface_mesh(plane_triangles(side, side, 1.0 / side, 0.3));
    const int source = side / 2 * (side + 1) + side / 2;
    const SpacePoint from = plane.mesh.positions[static_cast<std::size_t>(source)];
    const MapError error = error_of(plane, source, 0.45, [&](SpacePoint p) { return Complex{p.x - from.x, p.y - from.y}; });
    lines.begin("polar map, uneven plane of 20,000 faces");
    lines.at_most("distance, rms over radius", error.distance, 1e-5);
    lines.at_most("position, rms over radius", error.position, 1e-4);
    lines.say("milliseconds", 1e3 * error.seconds);
}

/// Without a closed form: maps from both ends agree.
void torus_lines(GrowthLines& lines) {
    constexpr double tube = 0.4, radius = 1.2;
    const SurfaceMesh torus = surface_mesh(torus_triangles(144, 72, 1, tube));
    double worst = 0;
    const int count = torus.vertices();
    for (int k = 0; k < 12; ++k) {
        const int a = k * count / 12;
        const PolarMap there = polar_map_of_vertex(torus, a, radius);
        for (std::size_t i = there.vertices.size() / 2; i < there.vertices.size(); i += there.vertices.size() / 5 + 1) {
            const PolarMap back = polar_map_of_vertex(torus, there.vertices[i], 1.1 * radius);
            const auto found = std::find(back.vertices.begin(), back.vertices.end(), a);
            const double distance =
                found == back.vertices.end() ? any : back.distance[static_cast<std::size_t>(found - back.vertices.begin())];
            worst = std::max(worst, std::abs(distance - there.distance[i]) / there.distance[i]);
        }
    }
    lines.begin("polar map, torus of 20,736 faces");
    lines.at_most("distance there and back, largest difference", worst, 0.01);
}

}  // namespace

void polar_map_lines(GrowthLines& lines, const SurfaceBenchOptions& options) {
    if (!options.wants("polar map")) return;
    plane_lines(lines);
    cylinder_lines(lines);
    sphere_lines(lines);
    torus_lines(lines);
}

}  // namespace rinceau::test
