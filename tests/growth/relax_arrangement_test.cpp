// Relaxation: the energy of eq. 5 never rises, and both ways to its minimum lead to the same place.

#include <catch2/catch.hpp>
#include <cmath>
#include <numeric>

#include "growth/arrangement/grow_arrangement.h"
#include "growth/arrangement/node_links.h"
#include "growth/arrangement/relax_all.h"
#include "growth/arrangement/relax_near.h"
#include "tests/growth/lattice_points.h"

namespace rinceau {

namespace {

ElementArrangement shaken(const Exemplar& exemplar, const ArrangeOptions& options, std::size_t count) {
    ElementArrangement arrangement = with_seed(empty_arrangement(exemplar, options), exemplar, {}, {0, 0});
    arrangement = grow(std::move(arrangement), exemplar, {}, {.count = count});
    Random random(3);
    for (std::size_t i = 0; i < arrangement.nodes.size(); ++i) {
        if (arrangement.nodes[i].dead || arrangement.nodes[i].held) continue;
        const double size = 0.2 * exemplar.mean_edge;
        const Point shift{random.uniform(-size, size), random.uniform(-size, size)};
        move_node(arrangement, static_cast<int>(i), arrangement.nodes[i].position + shift);
    }
    return arrangement;
}

std::vector<int> living(const ElementArrangement& arrangement) {
    std::vector<int> nodes;
    for (std::size_t i = 0; i < arrangement.nodes.size(); ++i)
        if (!arrangement.nodes[i].dead) nodes.push_back(static_cast<int>(i));
    return nodes;
}

}  // namespace

TEST_CASE("neither relaxation raises the energy") {
    const Exemplar exemplar = make_exemplar(irregular_points(99), {"A", "B"}, {}, "irregular");
    for (const RotationMode mode : {RotationMode::fixed, RotationMode::rotate}) {
        const ArrangeOptions options{.mode = mode};
        const ArrangeSurroundings around;
        const GrowthGround ground = make_ground(exemplar, around, options);
        ElementArrangement arrangement = shaken(exemplar, options, 150);
        double energy = ring_energy(arrangement);
        for (int sweep = 0; sweep < 5; ++sweep) {
            for (const int node : living(arrangement)) {
                relax_in_turn(arrangement, ground, {node});
                refit_angles(arrangement, ground, {node});
            }
            const double after = ring_energy(arrangement);
            CHECK(after <= energy * (1 + 1e-9));
            energy = after;
        }
        for (int round = 0; round < 3; ++round) {
            relax_all(arrangement, ground, 1);
            const double after = ring_energy(arrangement);
            CHECK(after <= energy * (1 + 1e-9));
            energy = after;
        }
        CHECK(energy > 0);
    }
}

TEST_CASE("sweeps over the nodes end where the sparse solve does") {
    const Exemplar exemplar = make_exemplar(irregular_points(99), {"A", "B"}, {}, "irregular");
    const ArrangeOptions options;
    const ArrangeSurroundings around;
    const GrowthGround ground = make_ground(exemplar, around, options);
    ElementArrangement swept = shaken(exemplar, options, 60);
    ElementArrangement solved = swept;
    relax_all(solved, ground, 1);
    const std::vector<int> nodes = living(swept);
    for (int sweep = 0; sweep < 4000; ++sweep) relax_in_turn(swept, ground, nodes);
    double farthest = 0;
    for (const int node : nodes) {
        const auto i = static_cast<std::size_t>(node);
        farthest = std::max(farthest, abs(swept.nodes[i].position - solved.nodes[i].position));
    }
    CHECK(farthest < 1e-6 * exemplar.mean_edge);
}

}  // namespace rinceau
