#include "analyzer/item_copies.h"

#include <algorithm>
#include <limits>

#include "analyzer/group_frame.h"
#include "analyzer/regauge.h"

namespace rinceau {

namespace {

Item& item_at(SearchState& state, int item) { return state.rules.items[static_cast<std::size_t>(item)]; }

}  // namespace

void keep_alive(SearchState& state, const std::vector<int>& items) {
    for (auto& members : state.members) members.clear();
    for (Item& item : state.rules.items) item.alive = false;
    for (const int item : items) {
        item_at(state, item).alive = true;
        state.members[static_cast<std::size_t>(state.item(item).part)].push_back(item);
    }
    std::vector<int> all(state.rules.parts.size());
    for (std::size_t p = 0; p < all.size(); ++p) {
        all[p] = static_cast<int>(p);
        std::ranges::sort(state.members[p]);
    }
    refresh(state, all);
}

int add_part(SearchState& state, Rule rule, Part part) {
    constexpr double guard_slack = 3;  // tolerances within which poses inside a part count as equal
    part.rule = static_cast<int>(state.rules.rules.size());
    state.rules.rules.push_back(std::move(rule));
    const PoseTolerance& tolerance = state.tolerance;
    part = completed_part(state.rules, std::move(part), guard_slack * tolerance.size, guard_slack * tolerance.angle);
    state.rules.parts.push_back(std::move(part));
    state.members.emplace_back();
    state.costs.emplace_back();
    return static_cast<int>(state.rules.parts.size()) - 1;
}

int add_item(SearchState& state, int part, const Similarity& pose, std::vector<int> members) {
    Item item;
    item.part = part;
    item.pose = pose;
    item.first = std::numeric_limits<int>::max();
    for (const int member : members) {
        if (member < 0) continue;
        item.first = std::min(item.first, state.item(member).first);
        item_at(state, member).alive = false;
    }
    item.members = std::move(members);
    state.rules.items.push_back(std::move(item));
    return static_cast<int>(state.rules.items.size()) - 1;
}

int add_group(SearchState& state, const std::vector<int>& items, const Similarity& pivot) {
    std::vector<Similarity> poses;
    const Similarity to_first = inverse(state.item(items.front()).pose);
    for (const int item : items) poses.push_back(to_first * state.item(item).pose);
    const std::vector<Similarity> children = centred(poses);
    Rule rule;
    rule.kind = RuleKind::group;
    Part part;
    for (std::size_t k = 0; k < items.size(); ++k) {
        rule.members.push_back({state.item(items[k]).part, poses[k]});
        part.children.push_back({state.item(items[k]).part, children[k]});
    }
    const Similarity frame = state.item(items.front()).pose * inverse(children.front());
    part.pivot = inverse(frame) * pivot;
    const int made = add_part(state, std::move(rule), std::move(part));
    return add_item(state, made, frame, items);
}

Copier::Copier(SearchState& state, const std::vector<std::vector<int>>& orbits) : state_(state), orbits_(orbits) {
    for (std::size_t o = 0; o < orbits.size(); ++o) {
        for (std::size_t k = 0; k < orbits[o].size(); ++k) places_.try_emplace(orbits[o][k], Place{o, k});
    }
}

int Copier::moved(int there, int item, const Similarity& map) {
    const Part& part = state_.part(state_.item(there).part);
    regauge(state_.rules, there, nearest_pose(part, state_.item(there).pose, map * state_.item(item).pose));
    item_at(state_, there).alive = false;
    return there;
}

}  // namespace rinceau
