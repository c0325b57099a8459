#include "analyzer/sector_rules.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "analyzer/group_frame.h"
#include "analyzer/regauge.h"

namespace rinceau {

namespace {

Item& item_at(SearchState& state, int item) { return state.rules.items[static_cast<std::size_t>(item)]; }

/// The first member of each orbit in a sector that begins in the widest gap between the items' directions.
std::vector<std::vector<int>> cut_into_sectors(const SearchState& state, const SceneRotation& rotation) {
    const double sector = two_pi / rotation.fold;
    const auto direction = [&](int item) {
        const double angle = std::fmod(arg(state.item(item).pose.translation - rotation.centre), sector);
        return angle < 0 ? angle + sector : angle;
    };
    std::vector<double> directions;
    for (const std::vector<int>& orbit : rotation.orbits) directions.push_back(direction(orbit.front()));
    std::ranges::sort(directions);
    double start = directions.front(), widest = directions.front() + sector - directions.back();
    for (std::size_t k = 0; k + 1 < directions.size(); ++k) {
        const double gap = directions[k + 1] - directions[k];
        if (gap > widest + 1e-9) {
            widest = gap;
            start = directions[k + 1];
        }
    }
    // Half a gap back, so that rounding does not tear what stands in one direction.
    const double begin = start - 0.5 * widest;
    std::vector<std::vector<int>> turned = rotation.orbits;
    for (std::vector<int>& orbit : turned) {
        const auto behind = [&](int item) {
            const double angle = std::fmod(arg(state.item(item).pose.translation - rotation.centre) - begin, two_pi);
            return angle < 0 ? angle + two_pi : angle;
        };
        std::ranges::rotate(orbit, std::ranges::min_element(orbit, {}, behind));
    }
    return turned;
}

/// Only these items are alive.
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
    part.rule = static_cast<int>(state.rules.rules.size());
    state.rules.rules.push_back(std::move(rule));
    const PoseTolerance& tolerance = state.tolerance;
    state.rules.parts.push_back(completed_part(state.rules, std::move(part), 3 * tolerance.size, 3 * tolerance.angle));
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

/// All roots of the sector as one item.
int sector_item(SearchState& state, const std::vector<int>& roots) {
    if (roots.size() == 1) return roots.front();
    std::vector<Similarity> poses;
    const Similarity to_first = inverse(state.item(roots.front()).pose);
    for (const int root : roots) poses.push_back(to_first * state.item(root).pose);
    const std::vector<Similarity> children = centred(poses);
    Rule rule;
    rule.kind = RuleKind::group;
    Part part;
    for (std::size_t k = 0; k < roots.size(); ++k) {
        rule.members.push_back({state.item(roots[k]).part, poses[k]});
        part.children.push_back({state.item(roots[k]).part, children[k]});
    }
    const int sector = add_part(state, std::move(rule), std::move(part));
    return add_item(state, sector, state.item(roots.front()).pose * inverse(children.front()), roots);
}

class Copier {
  public:
    Copier(SearchState& state, const std::vector<std::vector<int>>& orbits) : state_(state) {
        for (const std::vector<int>& orbit : orbits) orbit_of_[orbit.front()] = &orbit;
    }
    /// What stands `k` turns on from an item of the sector.
    int copy(int item, std::size_t k, const Similarity& turn) {
        const auto orbit = orbit_of_.find(item);
        if (orbit != orbit_of_.end()) {
            const int there = (*orbit->second)[k];
            const Part part = state_.part(state_.item(there).part);
            regauge(state_.rules, there, nearest_pose(part, state_.item(there).pose, turn * state_.item(item).pose));
            return there;
        }
        std::vector<int> members;
        const std::vector<int> below = state_.item(item).members;
        for (const int member : below) members.push_back(member < 0 ? member : copy(member, k, turn));
        const Similarity pose = turn * state_.item(item).pose;
        return add_item(state_, state_.item(item).part, pose, std::move(members));
    }

  private:
    SearchState& state_;
    std::map<int, const std::vector<int>*> orbit_of_;
};

void add_ring(SearchState& state, int sector, const SceneRotation& rotation, const std::vector<std::vector<int>>& orbits) {
    const Similarity first = state.item(sector).pose;
    const Similarity whole{first.linear, rotation.centre, first.mirrored};
    Rule rule;
    rule.kind = RuleKind::ring;
    rule.repeated = state.item(sector).part;
    Part part;
    part.count = rotation.fold;
    std::vector<int> members;
    Copier copier(state, orbits);
    for (int k = 0; k < rotation.fold; ++k) {
        const Complex turn = polar(1, two_pi * k / rotation.fold);
        const Similarity about{turn, rotation.centre - turn * rotation.centre, false};
        part.children.push_back({rule.repeated, inverse(whole) * about * first});
        members.push_back(k == 0 ? sector : copier.copy(sector, static_cast<std::size_t>(k), about));
        if (k == 1) rule.step = inverse(first) * about * first;
    }
    const int ring = add_part(state, std::move(rule), std::move(part));
    const int item = add_item(state, ring, whole, std::move(members));
    state.members[static_cast<std::size_t>(ring)].push_back(item);
}

}  // namespace

SearchState open_with_sectors(SearchState state, const SceneRotation& rotation, const SearchOptions& options,
                              const Progress& progress) {
    const std::vector<std::vector<int>> orbits = cut_into_sectors(state, rotation);
    // What the rotation does not move.
    std::vector<char> moved(state.rules.items.size(), 0);
    std::vector<int> sector, still;
    for (const std::vector<int>& orbit : orbits) {
        sector.push_back(orbit.front());
        for (const int item : orbit) moved[static_cast<std::size_t>(item)] = 1;
    }
    for (std::size_t i = 0; i < moved.size(); ++i) {
        if (state.rules.items[i].alive && !moved[i]) still.push_back(static_cast<int>(i));
    }
    std::vector<int> verbatim;  // alive but in no part's members: they stay roots
    std::erase_if(still, [&](int i) {
        const std::vector<int>& members = state.alive(state.item(i).part);
        const bool listed = std::ranges::binary_search(members, i);
        if (!listed) verbatim.push_back(i);
        return !listed;
    });
    // One sector, then the ring of it; the rest is left.
    keep_alive(state, sector);
    state = generate_rules(std::move(state), options, progress);
    const std::vector<int> roots = root_items(state.rules);
    add_ring(state, sector_item(state, roots), rotation, orbits);
    const int ring = static_cast<int>(state.rules.items.size()) - 1;
    keep_alive(state, still);
    for (const int item : verbatim) item_at(state, item).alive = true;
    item_at(state, ring).alive = true;
    return state;
}

}  // namespace rinceau
