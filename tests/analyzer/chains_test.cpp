#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "analyzer/chains.h"
#include "analyzer/rule_sets.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

std::vector<Similarity> steps_from(const Similarity& first, const Similarity& step, int count) {
    std::vector<Similarity> poses{first};
    while (static_cast<int>(poses.size()) < count) poses.push_back(poses.back() * step);
    return poses;
}

std::vector<Chain> chains_of(const RuleSet& rules, const Similarity& step) {
    const std::vector<int> all = counted(rules.items.size());
    return claimed(rules, sequence_chains(rules, PoseGrid(rules, 0, all), all, step, {}));
}

/// Every frame is its item's pose in some gauge and a step from the frame before it.
void check_frames(const RuleSet& rules, const Chain& chain, const Similarity& step) {
    REQUIRE(chain.items.size() == chain.frames.size());
    const SymmetryGroup& symmetry = rules.parts[0].symmetry;
    for (std::size_t k = 0; k < chain.items.size(); ++k) {
        CHECK(distance(chain.frames[k], rules.items[static_cast<std::size_t>(chain.items[k])].pose, symmetry) < 1e-9);
        if (k > 0) CHECK(distance(chain.frames[k - 1] * step, chain.frames[k]) < 1e-6);
    }
}

std::set<int> items_of(const std::vector<Chain>& chains) {
    std::set<int> items;
    for (const Chain& chain : chains) items.insert(chain.items.begin(), chain.items.end());
    return items;
}

std::size_t total(const std::vector<Chain>& chains) {
    std::size_t sum = 0;
    for (const Chain& chain : chains) sum += chain.items.size();
    return sum;
}

}  // namespace

TEST_CASE("a row is one chain, whatever the order of its items and their gauges") {
    Random random(1);
    const Similarity step = translate({0, 4});
    for (const SymmetryGroup& symmetry : {cyclic(1), cyclic(2), dihedral(1), dihedral(4), dihedral(6)}) {
        std::vector<Similarity> poses = steps_from({polar(2, 0.3), {5, 6}, false}, step, 9);
        for (std::size_t i = poses.size(); i > 1; --i) std::swap(poses[i - 1], poses[random.below(static_cast<std::uint32_t>(i))]);
        const RuleSet rules = regauged_at_random(copies(symmetry, poses), random);
        const std::vector<Chain> chains = chains_of(rules, step);
        REQUIRE(chains.size() == 1);
        CHECK(chains[0].items.size() == 9);
        CHECK_FALSE(chains[0].closed);
        check_frames(rules, chains[0], step);
    }
}

TEST_CASE("a sequence that grows and bends is one chain") {
    const Similarity step = rotate(0.3) * translate({0, 4}) * scale_by(0.9) * rotate(0.2);
    const RuleSet rules = copies(cyclic(1), steps_from({}, step, 15));
    const std::vector<Chain> chains = chains_of(rules, step);
    REQUIRE(chains.size() == 1);
    CHECK(chains[0].items == counted(15));
    check_frames(rules, chains[0], step);
}

TEST_CASE("footprints are one chain of glides") {
    const Similarity step = translate({0, 4}) * mirror_about_heading();
    const RuleSet rules = copies(cyclic(1), steps_from(translate({1, 0}), step, 10));
    const std::vector<Chain> chains = chains_of(rules, step);
    REQUIRE(chains.size() == 1);
    CHECK(chains[0].items == counted(10));
}

TEST_CASE("a ring is a closed chain that begins at the lowest element") {
    Random random(2);
    for (const SymmetryGroup& symmetry : {cyclic(1), dihedral(1), dihedral(4)}) {
        std::vector<Similarity> poses;
        for (int k = 0; k < 12; ++k) poses.push_back(rotate(two_pi * k / 12) * translate({0, 20}));
        const RuleSet rules = regauged_at_random(copies(symmetry, poses), random);
        const Similarity step = inverse(poses[0]) * poses[1];
        const std::vector<Chain> chains = chains_of(rules, step);
        REQUIRE(chains.size() == 1);
        CHECK(chains[0].closed);
        CHECK(chains[0].items.size() == 12);
        CHECK(chains[0].items.front() == 0);
        check_frames(rules, chains[0], step);
    }
}

TEST_CASE("a chain ends where an item is missing, has another size or belongs to something else") {
    const Similarity step = translate({0, 4});
    RuleSet rules = copies(cyclic(1), steps_from({}, step, 11));
    rules.items[3].alive = false;
    rules.items[7].pose = rules.items[7].pose * scale_by(1.2);
    const std::vector<Chain> chains = chains_of(rules, step);
    REQUIRE(chains.size() == 3);
    for (const Chain& chain : chains) CHECK(chain.items.size() == 3);
    CHECK(items_of(chains) == std::set<int>{0, 1, 2, 4, 5, 6, 8, 9, 10});
}

TEST_CASE("the chains of a lattice are its rows: each item in one of them") {
    std::vector<Similarity> poses;
    for (int row = 0; row < 6; ++row) {
        for (int column = 0; column < 8; ++column) poses.push_back(translate({3.0 * column, 5.0 * row}));
    }
    Random random(3);
    const RuleSet rules = regauged_at_random(copies(dihedral(4), poses), random);
    for (const auto& [step, count] : {std::pair{translate({3, 0}), std::size_t{6}}, std::pair{translate({0, 5}), std::size_t{8}}}) {
        const std::vector<Chain> chains = chains_of(rules, step);
        CHECK(chains.size() == count);
        CHECK(total(chains) == 48);
        CHECK(items_of(chains).size() == 48);
    }
    // Along a diagonal: disjoint all the same.
    const std::vector<Chain> slanting = chains_of(rules, translate({3, 5}));
    CHECK(total(slanting) == items_of(slanting).size());
}

TEST_CASE("where one step makes rows and columns, all chains run one way") {
    std::vector<Similarity> poses;
    for (int k = 0; k < 36; ++k) poses.push_back(translate({3.0 * (k % 6), 3.0 * (k / 6)}));
    const RuleSet rules = copies(dihedral(4), poses);
    const std::vector<int> all = counted(36);
    // Rows and columns as they come of discs, which have no direction; the last tile is missing.
    std::vector<Chain> lines;
    for (int line = 0; line < 6; ++line) {
        for (const bool row : {true, false}) {
            Chain chain;
            for (int k = 0; k < (line == 5 ? 5 : 6); ++k) {
                const int item = row ? 6 * line + k : 6 * k + line;
                chain.items.push_back(item);
                chain.frames.push_back(poses[static_cast<std::size_t>(item)]);
            }
            lines.push_back(chain);
        }
    }
    const std::vector<Chain> disjoint = claimed(rules, lines);
    REQUIRE(disjoint.size() == 6);
    CHECK(items_of(disjoint).size() == 35);
    for (const Chain& chain : disjoint) CHECK(chain.items.size() >= 5);
}

TEST_CASE("longer chains are claimed first, others are cut to their longest free run, scraps are left") {
    const RuleSet rules = copies(cyclic(1), std::vector<Similarity>(20));
    const auto chain = [&](std::vector<int> items) {
        Chain made;
        made.items = std::move(items);
        made.frames.resize(made.items.size());
        return made;
    };
    const std::vector<Chain> chains =
        claimed(rules, {chain({18, 19}), chain({6, 7, 3, 8, 9, 10}), chain({0, 1, 2, 3, 4, 5, 11}), chain({12, 13, 0, 1, 14})});
    REQUIRE(chains.size() == 2);
    CHECK(chains[0].items == std::vector<int>{0, 1, 2, 3, 4, 5, 11});
    CHECK(chains[1].items == std::vector<int>{8, 9, 10});
    CHECK(chains[1].frames.size() == 3);
    // Without a long chain, pairs count.
    CHECK(claimed(rules, {chain({18, 19}), chain({0, 1, 2})}).size() == 2);
}

TEST_CASE("a ring that is cut is closed no longer") {
    const RuleSet rules = copies(cyclic(1), std::vector<Similarity>(20));
    Chain ring{.items = {0, 1, 2, 3, 4, 5}, .frames = std::vector<Similarity>(6), .closed = true};
    Chain row{.items = {10, 11, 12, 13, 14, 15, 0}, .frames = std::vector<Similarity>(7)};
    const std::vector<Chain> chains = claimed(rules, {ring, row});
    REQUIRE(chains.size() == 2);
    CHECK(chains[1].items.size() == 5);
    CHECK_FALSE(chains[1].closed);
}

TEST_CASE("circles head along their chain: straight, bent and round") {
    for (const double bend : {0.0, 0.2, two_pi / 12}) {
        const Similarity step = translate({0, 4}) * rotate(bend);
        const RuleSet rules = copies(continuous(), steps_from(translate({3, -2}), step, 12));
        const std::vector<std::pair<int, int>> starts{{4, 5}, {0, 1}};
        const std::vector<Chain> chains = claimed(rules, directed_chains(rules, PoseGrid(rules, 0, counted(12)), starts, step, {}));
        REQUIRE(chains.size() == 1);
        CHECK(chains[0].items.size() == 12);
        CHECK(chains[0].closed == (bend == two_pi / 12));
        check_frames(rules, chains[0], step);
    }
}

TEST_CASE("a sequence whose turns grow evenly is found from its first pair") {
    Rule rule{.kind = RuleKind::linear, .step = rotate(0.2) * translate({0, 5}) * rotate(-0.1), .turn_change = 0.04, .spin_change = 0.02};
    const RuleSet rules = copies(cyclic(1), repetition_poses(rule, 10));
    const std::vector<std::pair<int, int>> starts{{0, 1}};
    const std::vector<LinearChain> chains = linear_chains(rules, PoseGrid(rules, 0, counted(10)), starts, rule, {});
    REQUIRE(chains.size() == 1);
    CHECK(chains[0].chain.items == counted(10));
    CHECK(distance(chains[0].first_step, rule.step) < 1e-9);
    rule.turn_change = 0.1;
    CHECK(linear_chains(rules, PoseGrid(rules, 0, counted(10)), starts, rule, {}).empty());
}
