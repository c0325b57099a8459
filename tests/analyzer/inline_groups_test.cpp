#include <catch2/catch.hpp>

#include <vector>

#include "analyzer/inline_groups.h"
#include "analyzer/redrawn.h"
#include "analyzer/rule_sets.h"

using namespace rinceau;
using namespace rinceau::test;

namespace {

const Similarity inner_place{polar(0.5, 0.3), {4, 1}, false};  // of B in the pair (A, B)
const Similarity outer_place{polar(2, -1), {-6, 2}, true};     // of the pair in the pair (C, (A, B))

/// Five places with C beside a pair of A and B: groups within groups.
RuleSet pairs_of_pairs() {
    RuleSet rules;
    for (int look = 0; look < 3; ++look) rules.parts.push_back(look_part(look, cyclic(1)));
    rules.rules.push_back({.kind = RuleKind::group, .members = {{0, {}}, {1, inner_place}}});
    rules.rules.push_back({.kind = RuleKind::group, .members = {{2, {}}, {3, outer_place}}});
    rules.parts.push_back({.rule = 0, .children = {{0, {}}, {1, inner_place}}, .leaves = 2});
    rules.parts.push_back({.rule = 1, .children = {{2, {}}, {3, outer_place}}, .leaves = 3});
    Random random(1);
    for (int k = 0; k < 5; ++k) {
        const Similarity pose = random_similarity(random);
        const int first = static_cast<int>(rules.items.size());
        const auto add = [&](int part, const Similarity& at, std::vector<int> members, int element, bool alive) {
            rules.items.push_back({.part = part, .pose = at, .members = std::move(members), .element = element, .first = 3 * k, .alive = alive});
        };
        add(2, pose, {}, 3 * k, false);
        add(0, pose * outer_place, {}, 3 * k + 1, false);
        add(1, pose * outer_place * inner_place, {}, 3 * k + 2, false);
        add(3, pose * outer_place, {first + 1, first + 2}, -1, false);
        add(4, pose, {first, first + 3}, -1, true);
    }
    return rules;
}

void check_members_in_place(const RuleSet& rules) {
    for (const int root : root_items(rules)) {
        const Item& item = rules.items[static_cast<std::size_t>(root)];
        const std::vector<Child>& children = rules.parts[static_cast<std::size_t>(item.part)].children;
        REQUIRE(children.size() == item.members.size());
        for (std::size_t k = 0; k < children.size(); ++k) {
            const Item& member = rules.items[static_cast<std::size_t>(item.members[k])];
            CHECK(member.part == children[k].part);
            CHECK(distance(member.pose, item.pose * children[k].pose) < 1e-9 * (1 + abs(member.pose.translation)));
        }
    }
}

}  // namespace

TEST_CASE("a pair within a pair, used nowhere else, becomes one group of three") {
    const RuleSet before = pairs_of_pairs();
    const RuleSet after = with_inlined_groups(before);
    CHECK(after.parts[4].children.size() == 3);
    CHECK(after.rules[1].members.size() == 3);
    CHECK(after.rules[1].members.front().pose == Similarity{});
    CHECK(root_items(after) == root_items(before));
    for (const int root : root_items(after)) CHECK(elements_below(after, root) == elements_below(before, root));
    check_members_in_place(after);
}

TEST_CASE("a group that also stands alone, or twice, stays a group") {
    RuleSet alone = pairs_of_pairs();
    alone.items.push_back({.part = 3, .pose = {}, .members = {}, .first = 99});
    CHECK(with_inlined_groups(alone).parts[4].children.size() == 2);

    RuleSet twice = pairs_of_pairs();
    twice.parts[4].children.push_back({3, translate({20, 0})});
    CHECK(with_inlined_groups(twice).parts[4].children.size() == 3);
}

TEST_CASE("what a sequence repeats is not taken apart") {
    RuleSet rules = pairs_of_pairs();
    rules.rules[1] = {.kind = RuleKind::sequence, .repeated = 3, .step = translate({5, 0})};
    rules.parts[4].children = {{3, {}}};
    for (Item& item : rules.items) {
        if (item.part == 4) item.members.erase(item.members.begin());
    }
    const RuleSet after = with_inlined_groups(rules);
    CHECK(after.parts[4].children.size() == 1);
    CHECK(after.parts[4].children[0].part == 3);
}
