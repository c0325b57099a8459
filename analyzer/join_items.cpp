#include "analyzer/join_items.h"

#include <algorithm>

#include "analyzer/gather.h"
#include "analyzer/group_frame.h"
#include "analyzer/regauge.h"

namespace rinceau {

int join_items(SearchState& state, int rule, const std::vector<int>& items, const std::vector<Similarity>& frames) {
    Item item;
    item.part = part_of_count(state, rule, static_cast<int>(items.size()));
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

}  // namespace rinceau
