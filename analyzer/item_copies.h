#pragma once
// Making parts and items by hand, for openings: what one sector, half or motif is, all its images are (docs/analysis.md, 4.6).

#include <map>
#include <vector>

#include "analyzer/search_state.h"

namespace rinceau {

/// Only these items are alive, and listed; in any order.
void keep_alive(SearchState& state, const std::vector<int>& items);

/// A new part of a new rule; its symmetry and radius are found. It has no items yet.
int add_part(SearchState& state, Rule rule, Part part);

/// A new item, alive but not listed; its members (-1 = missing) are no longer alive. Returns its index.
int add_item(SearchState& state, int part, const Similarity& pose, std::vector<int> members);

/// A new item of a new group of these items, in their order, and the group's part; `pivot` (scene frame) is where the group
/// is written from.
int add_group(SearchState& state, const std::vector<int>& items, const Similarity& pivot);

/// Makes the image of what rules have made of an orbit's first items.
class Copier {
  public:
    /// orbits[o][k] stands at map k times orbits[o][0], for all maps in use; kept as a reference.
    Copier(SearchState& state, const std::vector<std::vector<int>>& orbits);

    /// The image under `map`, which takes orbit member g of the items below `item` to `image_index(g)`. Items of orbits are
    /// brought into the pose that the map says, all others are made anew.
    template <typename ImageIndex>
    int copy(int item, const Similarity& map, const ImageIndex& image_index) {
        const auto place = places_.find(item);
        if (place != places_.end()) return moved(orbit_item(place->second, image_index(place->second.index)), item, map);
        std::vector<int> members;
        const std::vector<int> below = state_.item(item).members;
        for (const int member : below) members.push_back(member < 0 ? member : copy(member, map, image_index));
        return add_item(state_, state_.item(item).part, map * state_.item(item).pose, std::move(members));
    }

  private:
    struct Place {
        std::size_t orbit = 0, index = 0;
    };
    int orbit_item(const Place& place, std::size_t index) const { return orbits_[place.orbit][index]; }
    /// `there` in the pose, among its equivalent ones, nearest to that of the image.
    int moved(int there, int item, const Similarity& map);

    SearchState& state_;
    const std::vector<std::vector<int>>& orbits_;
    std::map<int, Place> places_;
};

}  // namespace rinceau
