// Meshes in, and collision of what stands on them (Li et al. 2010, section 4.4.1).

#include <cmath>

#include "geometry/random.h"
#include "growth/surface/collision_space.h"
#include "growth/surface/surface_read.h"
#include "made_inputs.h"
#include "sizes.h"

namespace rinceau::bench {
namespace {

std::string obj_text(const TriangleMesh& mesh) {
    std::string text;
    const auto number = [](double value) { return ' ' + std::to_string(value); };
    for (const SpacePoint& p : mesh.positions) text += 'v' + number(p.x) + number(p.y) + number(p.z) + '\n';
    for (const std::array<int, 3>& triangle : mesh.triangles) {
        text += 'f';
        for (const int corner : triangle) text += ' ' + std::to_string(corner + 1);
        text += '\n';
    }
    return text;
}

/// Read, checked, and made ready for growth.
void mesh_reading(benchmark::State& state) {
    const TriangleMesh mesh = torus_of(size_of(state));
    const std::string text = obj_text(mesh);
    for (auto _ : state) benchmark::DoNotOptimize(read_surface(text, "torus.obj"));
    set_size(state, mesh.triangles.size());
}
BENCHMARK(mesh_reading)->Apply(to_100000);

SpacePoint random_direction(Random& random) {
    SpacePoint way;
    do way = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    while (dot(way, way) > 1 || dot(way, way) < 1e-6);
    return unit(way);
}

GrammarShape unit_box() {
    GrammarShape box;
    box.name = "box";
    box.low = {-0.5, -0.5, -0.5};
    box.high = {0.5, 0.5, 0.5};
    return box;
}

/// Boxes of 1 by 0.7 by 0.4 thrown on a sphere that they would cover some times over.
std::vector<CollisionBody> thrown_boxes(const GrammarShape& box, int count) {
    constexpr double boxes_for_radius_1 = 30;
    const double radius = std::sqrt(count / boxes_for_radius_1);
    Random random(3);
    std::vector<CollisionBody> bodies;
    for (int i = 0; i < count; ++i) {
        const SpacePoint normal = random_direction(random);
        const SpacePoint x = unit(cross(normal, random_direction(random)));
        bodies.push_back(collision_body(box, radius * normal, {x, cross(normal, x), normal}, {1, 0.7, 0.4}, normal));
    }
    return bodies;
}

void collision(benchmark::State& state) {
    const GrammarShape box = unit_box();
    const std::vector<CollisionBody> bodies = thrown_boxes(box, size_of(state));
    for (auto _ : state) {
        CollisionSpace space;
        for (const CollisionBody& body : bodies)
            if (!space.overlap(body)) space.add(body);
        benchmark::DoNotOptimize(space.size());
    }
    set_size(state, bodies.size());
}
BENCHMARK(collision)->Apply(to_100000);

}  // namespace
}  // namespace rinceau::bench
