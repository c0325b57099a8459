#include <catch2/catch.hpp>

#include <algorithm>
#include <vector>

#include "analyzer/order_rules.h"
#include "analyzer/rule_sets.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

/// A row whose first repetition is the drawing's last element, and so on.
RuleSet row_against_the_drawing(int count) {
    std::vector<Similarity> poses;
    for (int k = 0; k < count; ++k) poses.push_back(translate({0, 3.0 * k}));
    RuleSet rules = copies(cyclic(1), poses);
    for (Item& item : rules.items) item.element = item.first = count - 1 - item.first;
    return grouped(rules, {.kind = RuleKind::sequence, .repeated = 0, .step = translate({0, 3})});
}

Overlaps neighbours_overlap(int count) {
    Overlaps overlaps;
    for (int k = 0; k + 1 < count; ++k) overlaps.pairs.push_back({k, k + 1});
    return overlaps;
}

/// The rule's repetitions, begun at the first member, are the members.
void check_step_leads_on(const RuleSet& rules) {
    const Item& whole = rules.items.back();
    const std::vector<Similarity> poses = repetition_poses(rules.rules[0], static_cast<int>(whole.members.size()));
    const Similarity& first = rules.items[static_cast<std::size_t>(whole.members[0])].pose;
    for (std::size_t k = 0; k < poses.size(); ++k) {
        const Similarity& member = rules.items[static_cast<std::size_t>(whole.members[k])].pose;
        CHECK(distance(first * poses[k], member) < 1e-9);
        CHECK(distance(whole.pose * rules.parts.back().children[k].pose, member) < 1e-9);
    }
}

}  // namespace

TEST_CASE("an overlapping row is run through in the order in which it is painted") {
    const OrderedRules ordered = ordered_for_painting(row_against_the_drawing(6), neighbours_overlap(6));
    REQUIRE(ordered.roots.size() == 1);
    CHECK(elements_below(ordered.rules, ordered.roots[0]) == counted(6));
    check_step_leads_on(ordered.rules);
}

TEST_CASE("a row without overlaps is run through in the order of the drawing") {
    const OrderedRules ordered = ordered_for_painting(row_against_the_drawing(6), {});
    CHECK(elements_below(ordered.rules, ordered.roots[0]) == counted(6));
    check_step_leads_on(ordered.rules);
}

TEST_CASE("a row in the right order stays as it is") {
    std::vector<Similarity> poses;
    for (int k = 0; k < 5; ++k) poses.push_back(translate({0, 3.0 * k}));
    const RuleSet rules = grouped(copies(cyclic(1), poses), {.kind = RuleKind::sequence, .repeated = 0, .step = translate({0, 3})});
    const OrderedRules ordered = ordered_for_painting(rules, neighbours_overlap(5));
    CHECK(elements_below(ordered.rules, ordered.roots[0]) == counted(5));
    CHECK(ordered.rules.rules[0].step == translate({0, 3}));
}

TEST_CASE("a ring is run through the other way round, from where it began") {
    constexpr int count = 8;
    std::vector<Similarity> poses;
    for (int k = 0; k < count; ++k) poses.push_back(rotate(two_pi * k / count) * translate({0, 9}));
    RuleSet rules = copies(cyclic(1), poses);
    for (Item& item : rules.items) item.element = item.first = (count - item.first) % count;
    const Similarity step = inverse(poses[0]) * poses[1];
    const OrderedRules ordered =
        ordered_for_painting(grouped(rules, {.kind = RuleKind::ring, .repeated = 0, .step = step}), neighbours_overlap(count));
    CHECK(elements_below(ordered.rules, ordered.roots[0]) == counted(count));
    check_step_leads_on(ordered.rules);
}

TEST_CASE("the members of a group are painted as the drawing paints them") {
    RuleSet rules = copies(cyclic(1), {Similarity{}, translate({1, 0}), translate({2, 0})});
    const std::vector<int> elements{2, 0, 1};
    for (std::size_t i = 0; i < 3; ++i) rules.items[i].element = rules.items[i].first = elements[i];
    const OrderedRules ordered = ordered_for_painting(grouped(rules, {.kind = RuleKind::group}), neighbours_overlap(3));
    CHECK(elements_below(ordered.rules, ordered.roots[0]) == counted(3));
    const Part& part = ordered.rules.parts.back();
    CHECK(distance(ordered.rules.rules[0].members[1].pose, inverse(part.children[0].pose) * part.children[1].pose) < 1e-12);
}

TEST_CASE("in the axiom what lies below stands before what lies above it") {
    RuleSet rules = copies(cyclic(1), std::vector<Similarity>(3));
    for (std::size_t i = 0; i < 3; ++i) rules.items[i].pose = translate({5.0 * static_cast<double>(i), 0});
    Overlaps overlaps;
    overlaps.pairs = {{2, 0}, {1, 2}};
    const OrderedRules ordered = ordered_for_painting(rules, overlaps);
    CHECK(ordered.roots == std::vector<int>{1, 2, 0});
}
