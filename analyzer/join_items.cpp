#include "analyzer/join_items.h"

#include <algorithm>

#include "analyzer/gather.h"
#include "analyzer/group_frame.h"
#include "analyzer/regauge.h"
#include "analyzer/substitute.h"

namespace rinceau {

namespace {

int join_as(SearchState& state, int part, const std::vector<int>& items, const std::vector<Similarity>& frames) {
    Item item;
    item.part = part;
    std::vector<Similarity> poses;
    std::vector<double> radii;
    for (const Child& child : state.part(item.part).children) {
        poses.push_back(child.pose);
        radii.push_back(std::max(1.0, state.part(child.part).radius));
    }
    item.pose = group_pose(poses, frames, radii);
    item.members = items;
    item.first = state.item(items.front()).first;
    for (std::size_t k = 0; k < items.size(); ++k) {
        regauge(state.rules, items[k], frames[k]);
        Item& member = state.rules.items[static_cast<std::size_t>(items[k])];
        member.alive = false;
        item.first = std::min(item.first, member.first);
    }
    const auto index = static_cast<int>(state.rules.items.size());
    state.members[static_cast<std::size_t>(item.part)].push_back(index);
    state.rules.items.push_back(std::move(item));
    return index;
}

/// The part of a family rule alike with these children, or -1.
int known_family(const SearchState& state, const Rule& family, const Part& wanted) {
    const double radius = std::max(1.0, state.part(family.repeated).radius);
    for (std::size_t p = 0; p < state.rules.parts.size(); ++p) {
        const Part& part = state.rules.parts[p];
        if (part.rule < 0) continue;
        const Rule& rule = state.rules.rules[static_cast<std::size_t>(part.rule)];
        if (rule.kind != RuleKind::family || part.children.size() != wanted.children.size()) continue;
        const bool same = std::ranges::equal(part.children, wanted.children, {}, &Child::part, &Child::part) &&
                          rule.step.mirrored == family.step.mirrored &&
                          abs(rule.step.translation - family.step.translation) <=
                              state.tolerance.shift(1, abs(family.step.translation)) &&
                          abs(rule.step.linear - family.step.linear) <= state.tolerance.turn(radius);
        if (same) return static_cast<int>(p);
    }
    return -1;
}

}  // namespace

int join_items(SearchState& state, int rule, const std::vector<int>& items, const std::vector<Similarity>& frames) {
    return join_as(state, part_of_count(state, rule, static_cast<int>(items.size())), items, frames);
}

int join_family(SearchState& state, const Rule& family, const std::vector<int>& items, const std::vector<Similarity>& frames) {
    Part part;
    part.count = static_cast<int>(items.size());
    const std::vector<Similarity> poses = centred(repetition_poses(family, part.count));
    for (std::size_t k = 0; k < items.size(); ++k) part.children.push_back({state.item(items[k]).part, poses[k]});
    int known = known_family(state, family, part);
    if (known < 0) {
        part.rule = static_cast<int>(state.rules.rules.size());
        state.rules.rules.push_back(family);
        known = static_cast<int>(state.rules.parts.size());
        state.rules.parts.push_back(completed_part(state.rules, std::move(part), guard_slack * state.tolerance.size,
                                                   guard_slack * state.tolerance.angle));
        state.members.emplace_back();
        state.costs.emplace_back();
    }
    return join_as(state, known, items, frames);
}

}  // namespace rinceau
