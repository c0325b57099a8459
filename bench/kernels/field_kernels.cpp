// Fields on surfaces, and ways along them (Li et al. 2010, sections 4.2 and 4.3).

#include "growth/surface/curvature_field.h"
#include "growth/surface/field_smooth.h"
#include "growth/surface/trace.h"
#include "made_inputs.h"
#include "sizes.h"
#include "tests/surface/surface_shapes.h"

namespace rinceau::bench {
namespace {

constexpr int lines = 2;  // n of a field of lines, which most patterns use

/// The smoothest field: an eigenvector of a sparse matrix as large as the surface.
void field_solve(benchmark::State& state) {
    const SurfaceMesh surface = surface_mesh(torus_of(size_of(state)));
    for (auto _ : state) benchmark::DoNotOptimize(smoothest_field(surface, lines));
    set_size(state, surface.mesh.triangles.size());
}
BENCHMARK(field_solve)->Apply(to_100000);

void curvature(benchmark::State& state) {
    const SurfaceMesh surface = surface_mesh(torus_of(size_of(state)));
    for (auto _ : state) benchmark::DoNotOptimize(curvature_field(surface));
    set_size(state, surface.mesh.triangles.size());
}
BENCHMARK(curvature)->Apply(to_100000);

/// So many walks, one mean edge long, on a torus of 10,000 faces.
void streamline_walks(benchmark::State& state) {
    constexpr int faces = 10'000;
    const SurfaceMesh surface = surface_mesh(torus_of(faces));
    const FieldOnSurface field(surface, guiding_curvature_field(surface));
    Random random(11);
    std::vector<std::pair<SurfacePoint, Complex>> starts;
    for (int i = 0; i < size_of(state); ++i) {
        const SurfacePoint at = random_surface_point(surface, random);
        starts.emplace_back(at, polar(1, random.uniform(0, two_pi)));
    }
    for (auto _ : state) {
        for (const auto& [at, direction] : starts)
            benchmark::DoNotOptimize(trace(surface, &field, at, direction, surface.mean_edge));
    }
    set_size(state, starts.size());
}
BENCHMARK(streamline_walks)->Apply(to_100000);

}  // namespace
}  // namespace rinceau::bench
