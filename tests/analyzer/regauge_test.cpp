#include <catch2/catch.hpp>

#include <vector>

#include "analyzer/redrawn.h"
#include "analyzer/regauge.h"
#include "analyzer/rule_sets.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

std::vector<Similarity> row_of(int count) {
    std::vector<Similarity> poses;
    for (int k = 0; k < count; ++k) poses.push_back(Similarity{polar(2, 0.4), {7, 8}, false} * translate({0, 3.0 * k}));
    return poses;
}

std::vector<Similarity> ring_of(int count) {
    std::vector<Similarity> poses;
    for (int k = 0; k < count; ++k) poses.push_back(Similarity{polar(1, 0.1), {-3, 5}, false} * rotate(two_pi * k / count) * translate({0, 9}));
    return poses;
}

/// The members of the last item stand where its part's children stand in its frame, and each on its own element still.
void check_regauged(const RuleSet& before, const RuleSet& after) {
    const Item& whole = after.items.back();
    const Part& part = after.parts[static_cast<std::size_t>(whole.part)];
    for (std::size_t k = 0; k < whole.members.size(); ++k) {
        const Item& member = after.items[static_cast<std::size_t>(whole.members[k])];
        CHECK(member.part == part.children[k].part);
        CHECK(distance(member.pose, whole.pose * part.children[k].pose) < 1e-6);
    }
    for (std::size_t i = 0; i + 1 < before.items.size(); ++i) {
        const SymmetryGroup& symmetry = before.parts[static_cast<std::size_t>(before.items[i].part)].symmetry;
        CHECK(distance(after.items[i].pose, before.items[i].pose, symmetry) < 1e-9 * (1 + abs(before.items[i].pose.translation)));
        CHECK(after.items[i].element == before.items[i].element);
    }
}

}  // namespace

TEST_CASE("in another gauge a group has its leaves where they were, in the order that it sees them in") {
    for (const SymmetryGroup& symmetry : {dihedral(4), dihedral(2), cyclic(2), continuous()}) {
        const RuleSet rules = grouped(copies(symmetry, row_of(5)), {.kind = RuleKind::sequence, .repeated = 0, .step = translate({0, 3})});
        const SymmetryGroup& whole = rules.parts.back().symmetry;
        REQUIRE(whole.elements.size() >= 2);
        for (const Similarity& gauge : whole.elements) {
            RuleSet turned = rules;
            regauge(turned, 5, rules.items[5].pose * gauge);
            check_regauged(rules, turned);
        }
    }
}

TEST_CASE("a half turn reverses a row") {
    RuleSet rules = grouped(copies(cyclic(2), row_of(4)), {.kind = RuleKind::sequence, .repeated = 0, .step = translate({0, 3})});
    const std::vector<int> before = elements_below(rules, 4);
    regauge(rules, 4, rules.items[4].pose * rotate(pi));
    const std::vector<int> after = elements_below(rules, 4);
    CHECK(after == std::vector<int>(before.rbegin(), before.rend()));
}

TEST_CASE("a ring in any of its gauges begins elsewhere and has the same leaves") {
    const RuleSet rules = grouped(copies(dihedral(1), ring_of(8)), {.kind = RuleKind::ring, .repeated = 0});
    REQUIRE(rules.parts.back().symmetry.elements.size() == 16);
    for (const Similarity& gauge : rules.parts.back().symmetry.elements) {
        RuleSet turned = rules;
        regauge(turned, 8, rules.items[8].pose * gauge);
        check_regauged(rules, turned);
    }
}
