#include "analyzer/tree_extras.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "analyzer/grow_tree.h"
#include "analyzer/regauge.h"
#include "geometry/kd_tree.h"

namespace rinceau {

namespace {

constexpr std::size_t neighbours_asked = 8;
constexpr double link_slack = 2;
constexpr double most_missing = 0.1;  // of the nodes
constexpr double least_saved_bits = 20;
constexpr std::size_t most_extras = 12;

/// An extra item at each place, -1 where it is missing.
struct Extra {
    Child child;
    std::vector<int> items;
};

class ExtraFinder {
  public:
    ExtraFinder(const SearchState& state, TreesOfRule found) : state_(state), found_(std::move(found)) {
        used_.assign(state.rules.items.size(), 0);
        for (const BranchTree& tree : found_.trees) {
            for (const BranchNode& node : tree.nodes) {
                nodes_.push_back(node.frame);
                for (const int item : node.items) used_[static_cast<std::size_t>(item)] = 1;
            }
            const std::size_t branches = found_.rule.steps.size();
            const std::size_t first = nodes_of_tree(branches, tree.depth - 1);
            for (std::size_t node = first; node < tree.nodes.size(); ++node) {
                for (const Similarity& step : found_.rule.steps) ends_.push_back(tree.nodes[node].frame * step);
            }
        }
    }

    TreesOfRule run() {
        const std::vector<Extra> members = extras_at(nodes_), leaves = extras_at(ends_);
        std::size_t next_node = 0, next_end = 0;
        for (BranchTree& tree : found_.trees) {
            const std::size_t branches = found_.rule.steps.size();
            const std::size_t ends = (tree.nodes.size() - nodes_of_tree(branches, tree.depth - 1)) * branches;
            for (BranchNode& node : tree.nodes) {
                for (const Extra& extra : members) node.items.push_back(extra.items[next_node]);
                ++next_node;
            }
            for (std::size_t end = 0; !leaves.empty() && end < ends; ++end) {
                BranchNode leaf{ends_[next_end], {}};
                for (const Extra& extra : leaves) leaf.items.push_back(extra.items[next_end]);
                tree.nodes.push_back(std::move(leaf));
                ++next_end;
            }
        }
        for (const Extra& extra : members) found_.rule.members.push_back(extra.child);
        for (const Extra& extra : leaves) found_.rule.leaves.push_back(extra.child);
        return std::move(found_);
    }

  private:
    const SearchState& state_;
    TreesOfRule found_;
    std::vector<char> used_;
    std::vector<Similarity> nodes_, ends_;

    std::vector<Extra> extras_at(const std::vector<Similarity>& places) {
        std::vector<Extra> extras;
        for (std::size_t p = 0; p < state_.members.size() && extras.size() < most_extras; ++p) {
            std::vector<int> items = state_.members[p];
            std::erase_if(items, [&](int i) { return used_[static_cast<std::size_t>(i)] != 0; });
            if (static_cast<double>(items.size()) < (1 - most_missing) * static_cast<double>(places.size())) continue;
            add_extras(static_cast<int>(p), items, places, extras);
        }
        return extras;
    }

    void add_extras(int part, const std::vector<int>& items, const std::vector<Similarity>& places,
                    std::vector<Extra>& extras) {
        std::vector<Point> origins;
        for (const int i : items) origins.push_back(state_.item(i).pose.translation);
        const KdTree tree(origins);
        const PoseGrid grid(state_.rules, part, items);
        // The lowest place, and the last one in case that something is missing at the first.
        for (const Similarity& from : {places.front(), places.back()}) {
            for (const Neighbor& near : tree.nearest(from.translation, neighbours_asked)) {
                const int item = items[near.index];
                if (used_[static_cast<std::size_t>(item)] || extras.size() >= most_extras) continue;
                const Similarity within = inverse(from) * state_.item(item).pose;
                if (auto extra = extra_of(part, within, grid, places)) {
                    for (const int each : extra->items) {
                        if (each >= 0) used_[static_cast<std::size_t>(each)] = 1;
                    }
                    extras.push_back(std::move(*extra));
                }
            }
        }
    }

    std::optional<Extra> extra_of(int part, const Similarity& within, const PoseGrid& grid,
                                  const std::vector<Similarity>& places) const {
        const PoseTolerance tolerance{link_slack * state_.tolerance.size, link_slack * state_.tolerance.angle,
                                      state_.tolerance.per_distance};
        Extra extra{{part, within}, {}};
        Similarity sum{{0, 0}, {}, within.mirrored};
        double weights = 0, missing = 0;
        std::vector<int> taken;
        for (const Similarity& place : places) {
            const Similarity predicted = place * within;
            const auto match = grid.find(predicted, abs(predicted.translation - place.translation), tolerance);
            const bool there = match && !used_[static_cast<std::size_t>(match->item)];
            extra.items.push_back(there ? match->item : -1);
            missing += there ? 0 : 1;
            if (missing > most_missing * static_cast<double>(places.size())) return std::nullopt;
            if (!there) continue;
            taken.push_back(match->item);
            const Similarity exact = inverse(place) * matched_frame(state_, *match, predicted);
            const double weight = norm(place.linear);
            sum.linear += weight * exact.linear;
            sum.translation += weight * exact.translation;
            weights += weight;
        }
        std::ranges::sort(taken);
        if (std::ranges::adjacent_find(taken) != taken.end()) return std::nullopt;
        const double count = static_cast<double>(taken.size());
        const double saved = (count - 1) * state_.cost(part).item_bits - step_bits(state_, part, part, within);
        if (saved < least_saved_bits || !(weights > 0)) return std::nullopt;
        extra.child.pose = {sum.linear / weights, sum.translation / weights, sum.mirrored};
        return extra;
    }
};

}  // namespace

TreesOfRule with_extras(const SearchState& state, TreesOfRule found) {
    return ExtraFinder(state, std::move(found)).run();
}

}  // namespace rinceau
