#include "analyzer/settle_gaps.h"

#include <algorithm>

namespace rinceau {

namespace {

struct Gap {
    int item = 0;
    std::size_t member = 0;
};

void collect_gaps(const SearchState& state, int i, std::vector<Gap>& gaps) {
    const Item& item = state.item(i);
    for (std::size_t k = 0; k < item.members.size(); ++k) {
        if (item.members[k] < 0) {
            gaps.push_back({i, k});
        } else {
            collect_gaps(state, item.members[k], gaps);
        }
    }
}

}  // namespace

void settle_gaps(SearchState& state, GridCache& grids) {
    std::vector<Gap> gaps;
    for (const int root : root_items(state.rules)) collect_gaps(state, root, gaps);
    for (const Gap& gap : gaps) {
        const Item& holder = state.item(gap.item);
        if (gap.member >= holder.members.size()) continue;  // has given up its members to another gap
        const Child child = state.part(holder.part).children[gap.member];
        const Similarity place = holder.pose * child.pose;
        const double distance = abs(place.translation - holder.pose.translation);
        const auto found = gather(state, grids, child.part, place, distance, true);
        if (!found || (found->item >= 0 && state.item(found->item).part != child.part)) continue;
        std::set<int> touched;
        const int made = make_item(state, child.part, *found, place, touched);
        if (made < 0) continue;
        Item& member = state.rules.items[static_cast<std::size_t>(made)];
        Item& above = state.rules.items[static_cast<std::size_t>(gap.item)];
        member.alive = false;
        above.members[gap.member] = made;
        above.first = std::min(above.first, member.first);
        touched.insert(child.part);
        for (const int part : touched) grids.forget(part);
        refresh(state, {touched.begin(), touched.end()});
    }
}

}  // namespace rinceau
