#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

#include "analyzer/fit_step.h"
#include "analyzer/rule_sets.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

constexpr double radius = 1;

/// The repetitions of a rule, with places and directions rounded to multiples of `rounding` item sizes.
Chain rounded_chain(const Rule& rule, int count, double rounding) {
    Chain chain;
    for (const Similarity& pose : repetition_poses(rule, count)) {
        const double grid = rounding * scale_of(pose);
        const auto round = [&](Point p) { return Point{std::round(p.x / grid) * grid, std::round(p.y / grid) * grid}; };
        // A pose is read off two rounded points: its origin and the tip of its heading.
        const Point origin = rounding > 0 ? round(pose.translation) : pose.translation;
        const Point tip = rounding > 0 ? round(pose.translation + pose.linear) : pose.translation + pose.linear;
        chain.items.push_back(static_cast<int>(chain.items.size()));
        chain.frames.push_back({tip - origin, origin, pose.mirrored});
    }
    return chain;
}

/// How far the last of `count` repetitions is from where it should be, in its sizes, both sequences beginning alike.
double error_at_end(const Rule& found, const Rule& wanted, int count) {
    const Similarity a = repetition_poses(found, count).back(), b = repetition_poses(wanted, count).back();
    return abs(a.translation - b.translation) / scale_of(b);
}

Rule sequence(double turn, double advance, double scale, double spin) {
    return {.kind = RuleKind::sequence, .step = rotate(turn) * translate({0, advance}) * scale_by(scale) * rotate(spin)};
}

Rule rule_of_mean(const std::vector<Chain>& chains) {
    return {.kind = RuleKind::sequence, .step = mean_step(chains)};
}

}  // namespace

TEST_CASE("a row of a thousand is fitted to its last element") {
    const Rule wanted = sequence(0, 3, 1, 0);
    const std::vector<Chain> chains{rounded_chain(wanted, 1000, 1e-2)};
    const Rule found = fitted(rule_of_mean(chains), chains, radius);
    CHECK(error_at_end(found, wanted, 1000) < 1e-5);
    // Off the grid of the rounding: the error of a slope fitted to a thousand values of that noise.
    const Rule uneven = sequence(0, 3.0137, 1, 0);
    const std::vector<Chain> rough{rounded_chain(uneven, 1000, 1e-2)};
    const Rule straight = with_natural_values(fitted(rule_of_mean(rough), rough, radius), rough, radius, 1e-3);
    CHECK(error_at_end(straight, uneven, 1000) < 2e-2);
    CHECK(worst_deviation(straight, rough, radius) < 3e-2);
}

TEST_CASE("the helix is fitted to the rounding of its coordinates, where a mean of steps drifts") {
    const Rule wanted = sequence(0, 27.5 / 12, 0.993, radians(8.5));
    const std::vector<Chain> chains{rounded_chain(wanted, 337, 1e-3)};
    const Rule mean = rule_of_mean(chains);
    const Rule found = fitted(mean, chains, radius);
    CHECK(worst_deviation(found, chains, radius) < 2e-3);
    CHECK(worst_deviation(mean, chains, radius) > 4 * worst_deviation(found, chains, radius));
    CHECK(scale_of(found.step) == Approx(0.993).epsilon(1e-5));
    CHECK(degrees(arg(found.step.linear)) == Approx(8.5).epsilon(1e-4));
}

TEST_CASE("several chains of one rule are fitted together, each in its own place") {
    const Rule wanted = sequence(0.1, 4, 1.01, 0.2);
    std::vector<Chain> chains;
    for (int k = 0; k < 5; ++k) {
        chains.push_back(rounded_chain(wanted, 6 + k, 0));
        for (Similarity& frame : chains.back().frames) frame = Similarity{polar(1.0 + k, k), {10.0 * k, 7}, k % 2 == 1} * frame;
    }
    const Rule found = fitted({.step = rotate(0.12) * translate({0.1, 4}) * rotate(0.2)}, chains, radius);
    CHECK(distance(found.step, wanted.step) < 1e-6);
    CHECK(worst_deviation(found, chains, radius) < 1e-6);
}

TEST_CASE("a fitted ring closes exactly") {
    Chain ring{.closed = true};
    Random random(4);
    for (int k = 0; k < 17; ++k) {
        Similarity pose = rotate(two_pi * k / 17) * translate({0, 20});
        pose.translation += Point{random.uniform(-5e-3, 5e-3), random.uniform(-5e-3, 5e-3)};
        ring.items.push_back(k);
        ring.frames.push_back(pose);
    }
    const std::vector<Chain> chains{ring};
    const Rule found = fitted({.kind = RuleKind::ring, .step = mean_step(chains)}, chains, radius);
    const Similarity round = repetition_poses(found, 18).back();
    CHECK(distance(round, {}) < 1e-9);
    CHECK(worst_deviation(found, chains, radius) < 2e-2);
}

TEST_CASE("the changes of a linear rule are fitted as well") {
    const Rule wanted{.kind = RuleKind::linear, .step = rotate(0.3) * translate({0, 4}) * rotate(-0.2), .turn_change = 0.05, .spin_change = 0.03};
    const std::vector<Chain> chains{rounded_chain(wanted, 20, 1e-3)};
    Rule guess = wanted;
    guess.turn_change = 0.052;
    guess.spin_change = 0.029;
    guess.step = guess.step * rotate(0.01);
    const Rule found = fitted(guess, chains, radius);
    CHECK(worst_deviation(found, chains, radius) < 3e-3);
    CHECK(found.turn_change == Approx(0.05).epsilon(0.01));
    CHECK(found.spin_change == Approx(0.03).epsilon(0.02));
}

TEST_CASE("natural values are taken where they fit, and only there") {
    const double noise = 1e-4;
    const Rule nearly = sequence(radians(90) + noise, 3, 1 + noise, radians(-90) - noise);
    const std::vector<Chain> row{rounded_chain(sequence(radians(90), 3, 1, radians(-90)), 8, 0)};
    const Rule natural = with_natural_values(nearly, row, radius, 1e-2);
    CHECK(abs(natural.step.linear - Complex{1, 0}) < 1e-12);
    CHECK(std::abs(natural.step.translation.y) < 1e-9);

    const Rule odd = sequence(radians(7.3), 3, 0.97, radians(11.1));
    const std::vector<Chain> bent{rounded_chain(odd, 8, 0)};
    CHECK(distance(with_natural_values(odd, bent, radius, 1e-3).step, odd.step) < 1e-3);
}
