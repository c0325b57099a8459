// Collision: time of placements in a space that fills, and its answers against all pairs.

#include <cmath>

#include "geometry/random.h"
#include "growth/surface/collision_space.h"
#include "surface_bench.h"

namespace rinceau::test {
namespace {

constexpr double touch = 0.02;

GrammarShape unit_box() {
    GrammarShape box;
    box.name = "box";
    box.low = {-0.5, -0.5, -0.5};
    box.high = {0.5, 0.5, 0.5};
    return box;
}

SpacePoint random_direction(Random& random) {
    SpacePoint way;
    do way = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
    while (dot(way, way) > 1 || dot(way, way) < 1e-6);
    return unit(way);
}

/// Boxes of the size 1 by 0.7 by 0.4 on a sphere, as many as cover it a few times.
std::vector<CollisionBody> random_bodies(int count, std::uint64_t seed) {
    static const GrammarShape box = unit_box();
    Random random(seed);
    const double radius = std::sqrt(count / 30.0);
    std::vector<CollisionBody> bodies;
    for (int i = 0; i < count; ++i) {
        const SpacePoint normal = random_direction(random);
        const SpacePoint x = unit(cross(normal, random_direction(random)));
        bodies.push_back(collision_body(box, radius * normal, {x, cross(normal, x), normal}, {1, 0.7, 0.4}, normal));
    }
    return bodies;
}

std::vector<int> placed(const std::vector<CollisionBody>& bodies) {
    CollisionSpace space;
    std::vector<int> kept;
    for (std::size_t i = 0; i < bodies.size(); ++i)
        if (!space.overlap(bodies[i])) {
            space.add(bodies[i]);
            kept.push_back(static_cast<int>(i));
        }
    return kept;
}

std::vector<int> placed_by_all_pairs(const std::vector<CollisionBody>& bodies) {
    std::vector<int> kept;
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        bool clear = true;
        for (const int other : kept)
            clear = clear && !bodies_overlap(bodies[i], bodies[static_cast<std::size_t>(other)], 1 - touch, 1 - touch);
        if (clear) kept.push_back(static_cast<int>(i));
    }
    return kept;
}

}  // namespace

void collision_lines(GrowthLines& lines, const SurfaceBenchOptions& options) {
    if (!options.wants("collision")) return;
    constexpr int many = 20000, few = 4000;
    const std::vector<CollisionBody> bodies = random_bodies(many, 3);
    std::vector<int> kept;
    const double seconds = best_seconds(3, [&] { kept = placed(bodies); });
    lines.begin("collision, 20,000 boxes");
    lines.at_most("milliseconds", 1e3 * seconds, 60);
    lines.say("placed", static_cast<double>(kept.size()));
    const std::vector<CollisionBody> fewer = random_bodies(few, 4);
    lines.at_most("of 4,000: decisions unlike those by all pairs", placed(fewer) == placed_by_all_pairs(fewer) ? 0 : 1, 0);
}

}  // namespace rinceau::test
