// Indices, curvature and the smoothest fields (bars: docs/growth.md, "Patterns on surfaces").

#include <cmath>
#include <cstdlib>

#include "tests/surface/surface_shapes.h"
#include "growth/surface/curvature_field.h"
#include "growth/surface/field_smooth.h"
#include "surface_bench.h"
#include "surface_cases.h"

namespace rinceau::test {
namespace {

SurfaceField random_field(const SurfaceMesh& surface, int n, std::uint64_t seed) {
    Random random(seed);
    SurfaceField field{.n = n};
    for (int v = 0; v < surface.vertices(); ++v) field.values.push_back({random.uniform(-1, 1), random.uniform(-1, 1)});
    return field;
}

void index_lines(GrowthLines& lines, const std::vector<MeshCase>& cases) {
    lines.begin("fields, sum of indices");
    for (const MeshCase& one : cases) {
        if (!is_closed(one)) continue;
        double off = 0;
        for (const int n : {1, 2, 4}) {
            const FieldOnSurface field(*one.surface, random_field(*one.surface, n, 5));
            off = std::max(off, std::abs(static_cast<double>(field.index_sum()) / n - euler_characteristic(*one.surface)));
        }
        lines.at_most(one.name + ": off the Euler characteristic", off, 0);
    }
}

void smoothest_lines(GrowthLines& lines) {
    const SurfaceMesh sphere = surface_mesh(sphere_triangles(5));
    lines.begin("fields, smoothest on a sphere of 20,480 faces");
    for (const int n : {2, 4}) {
        SurfaceField field;
        const double seconds = best_seconds(1, [&] { field = smoothest_field(sphere, n); });
        const FieldOnSurface ready(sphere, std::move(field));
        lines.between("singular points, n = " + std::to_string(n), static_cast<double>(ready.singular_faces().size()), 2 * n,
                      2 * n);
        lines.say("milliseconds", 1e3 * seconds);
    }
}

void curvature_lines(GrowthLines& lines) {
    constexpr double large = 1, small = 0.4;
    const SurfaceMesh torus = surface_mesh(torus_triangles(150, 72, large, small));
    SurfaceField field;
    const double seconds = best_seconds(3, [&] { field = curvature_field(torus); });
    double first = 0, second = 0, direction = 0;
    for (int v = 0; v < torus.vertices(); ++v) {
        const auto i = static_cast<std::size_t>(v);
        const SpacePoint p = torus.mesh.positions[i];
        const double ring = std::hypot(p.x, p.y);
        const double across = 1 / small, along = (ring - large) / small / ring;
        const double found_across = field.isotropic[i] + abs(field.values[i]),
                     found_along = field.isotropic[i] - abs(field.values[i]);
        first += (found_across - across) * (found_across - across);
        second += (found_along - along) * (found_along - along);
        // The larger curvature is that of the small circle: at right angles to the way round the axis.
        const SpacePoint round{-p.y / ring, p.x / ring, 0};
        const double angle = std::atan2(field.values[i].y, field.values[i].x) / 2;
        const SurfacePoint at = at_vertex(torus, v);
        const SpacePoint found =
            direction_in_space(torus, at.face, from_vertex_frame(torus, v, {std::cos(angle), std::sin(angle)}));
        const double off = degrees(std::asin(std::min(1.0, std::abs(dot(found, round)))));
        direction += off * off;
    }
    const double count = torus.vertices();
    lines.begin("fields, curvature of a torus of 21,600 faces");
    lines.at_most("larger one, rms of its value", std::sqrt(first / count) * small, 2e-3);
    lines.say("smaller one, rms over the larger", std::sqrt(second / count) * small);
    lines.at_most("direction, rms (degrees)", std::sqrt(direction / count), 0.1);
    lines.say("milliseconds", 1e3 * seconds);
}

}  // namespace

void field_lines(GrowthLines& lines, const SurfaceBenchOptions& options, const std::vector<MeshCase>& meshes) {
    if (!options.wants("fields")) return;
    index_lines(lines, meshes);
    smoothest_lines(lines);
    curvature_lines(lines);
}

}  // namespace rinceau::test
