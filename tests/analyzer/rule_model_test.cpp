#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

#include "analyzer/pose_grid.h"
#include "analyzer/rule_sets.h"
#include "analyzer/step_votes.h"

using namespace rinceau;
using namespace rinceau::test;

TEST_CASE("repetitions follow the step, or the steps that grow") {
    const Rule steady{.kind = RuleKind::sequence, .step = rotate(0.1) * translate({0, 2}) * scale_by(0.9)};
    const std::vector<Similarity> poses = repetition_poses(steady, 6);
    REQUIRE(poses.size() == 6);
    CHECK(poses[0] == Similarity{});
    for (std::size_t k = 1; k < 6; ++k) CHECK(distance(poses[k - 1] * steady.step, poses[k]) < 1e-12);

    const Rule growing{.kind = RuleKind::linear, .step = rotate(0.1) * translate({0, 2}) * rotate(0.2), .turn_change = 0.03, .spin_change = -0.05};
    CHECK(distance(linear_step(growing, 0), growing.step) < 1e-12);
    CHECK(distance(linear_step(growing, 4), rotate(0.1 + 4 * 0.03) * translate({0, 2}) * rotate(0.2 - 4 * 0.05)) < 1e-12);
    const std::vector<Similarity> bent = repetition_poses(growing, 6);
    for (int k = 0; k < 5; ++k) {
        CHECK(distance(bent[static_cast<std::size_t>(k)] * linear_step(growing, k), bent[static_cast<std::size_t>(k) + 1]) < 1e-12);
    }
}

TEST_CASE("a grid finds the item that is where it should be, as a search through all items does") {
    Random random(1);
    std::vector<Similarity> poses;
    for (int k = 0; k < 300; ++k) {
        poses.push_back({polar(random.uniform(0.5, 2), random.uniform(-pi, pi)), {random.uniform(0, 20), random.uniform(0, 20)}, random.below(2) == 1});
    }
    RuleSet rules = copies(dihedral(3), poses);
    for (int k = 0; k < 300; k += 7) rules.items[static_cast<std::size_t>(k)].alive = false;
    const PoseGrid grid(rules, 0, counted(300));
    const PoseTolerance tolerance{.size = 0.5, .angle = 0.3, .per_distance = 0};
    int hits = 0;
    for (int trial = 0; trial < 600; ++trial) {
        Similarity predicted = poses[random.below(300)] * rules.parts[0].symmetry.elements[random.below(6)];
        predicted.translation += Point{random.uniform(-1, 1), random.uniform(-1, 1)};
        int nearest = -1;
        double least = HUGE_VAL;
        for (int i = 0; i < 300; ++i) {
            const Item& item = rules.items[static_cast<std::size_t>(i)];
            const double shift = abs(item.pose.translation - predicted.translation);
            const bool fits = item.alive && shift <= tolerance.shift(scale_of(predicted), 1) &&
                              matching_gauge(rules.parts[0], item.pose, predicted, tolerance.turn(1)) >= 0;
            if (fits && shift < least) {
                least = shift;
                nearest = i;
            }
        }
        const auto match = grid.find(predicted, 1, tolerance);
        REQUIRE(match.has_value() == (nearest >= 0));
        if (!match) continue;
        ++hits;
        CHECK(match->item == nearest);
        CHECK(match->shift == Approx(least));
        const Similarity& gauge = rules.parts[0].symmetry.elements[static_cast<std::size_t>(match->gauge)];
        CHECK(abs((poses[static_cast<std::size_t>(nearest)] * gauge).linear - predicted.linear) < 1);
    }
    CHECK(hits > 100);
}

TEST_CASE("votes that agree are one cluster, the largest first, the mirrored ones apart") {
    Random random(2);
    const VoteCell cell;
    StepVotes votes;
    const std::vector<Similarity> steps{translate({0, 3}), translate({3, 0}), translate({0, 3}) * mirror_about_heading()};
    const std::vector<int> counts{20, 50, 35};
    for (std::size_t s = 0; s < steps.size(); ++s) {
        for (int k = 0; k < counts[s]; ++k) {
            StepVote vote{.step = steps[s], .source = k, .target = k + 1};
            vote.step.translation += Point{random.uniform(-1e-3, 1e-3), random.uniform(-1e-3, 1e-3)};
            votes.add(vote, step_coordinates(vote.step, cell));
        }
    }
    votes.add({.step = translate({9, 9})}, step_coordinates(translate({9, 9}), cell));
    CHECK(votes.size() == 106);
    const std::vector<StepCluster> clusters = votes.clusters(2, 10);
    REQUIRE(clusters.size() == 3);
    CHECK(clusters[0].votes.size() == 50);
    CHECK(clusters[1].votes.size() == 35);
    CHECK(clusters[2].votes.size() == 20);
    CHECK(distance(clusters[0].step, steps[1]) < 1e-3);
    CHECK(clusters[1].step.mirrored);
    CHECK(votes.clusters(2, 1).size() == 1);
    CHECK(votes.clusters(1, 10).size() == 4);
}
