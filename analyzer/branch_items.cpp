#include "analyzer/branch_items.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "analyzer/group_frame.h"
#include "analyzer/regauge.h"

namespace rinceau {

namespace {

constexpr double guard_slack = 3;  // tolerances that equal poses inside a part may differ by

class TreeBuilder {
  public:
    TreeBuilder(SearchState& state, const Rule& rule)
        : state_(state), rule_(rule), rule_index_(static_cast<int>(state.rules.rules.size())) {
        state_.rules.rules.push_back(rule);
    }

    /// The item of the subtree above a node.
    int item_of(const BranchTree& tree, std::size_t node, int depth) {
        const BranchNode& at = tree.nodes[node];
        std::vector<int> members, parts;
        const auto add = [&](int item, const Child& stands, const Similarity& frame) {
            members.push_back(placed(item, frame * stands.pose));
            parts.push_back(item >= 0 ? state_.item(item).part : stands.part);
        };
        for (std::size_t k = 0; k < at.items.size(); ++k) add(at.items[k], rule_.members[k], at.frame);
        const std::size_t branches = rule_.steps.size();
        for (std::size_t k = 0; k < branches; ++k) {
            const std::size_t child = branches * node + 1 + k;
            if (depth > 1) {
                members.push_back(item_of(tree, child, depth - 1));
                continue;
            }
            if (rule_.leaves.empty()) continue;  // nodes of depth 0 are not there
            const BranchNode& end = tree.nodes[child];
            for (std::size_t l = 0; l < rule_.leaves.size(); ++l) add(end.items[l], rule_.leaves[l], end.frame);
        }
        return new_item(part_of(depth, parts), at.frame, std::move(members));
    }

    const std::set<int>& touched() const { return touched_; }

  private:
    SearchState& state_;
    const Rule rule_;
    int rule_index_;
    std::map<int, int> part_of_depth_;
    std::set<int> touched_;

    Item& item_at(int item) { return state_.rules.items[static_cast<std::size_t>(item)]; }

    int placed(int item, const Similarity& frame) {
        if (item < 0) return item;
        const Part& part = state_.part(state_.item(item).part);
        regauge(state_.rules, item, nearest_pose(part, state_.item(item).pose, frame));
        return item;
    }

    /// `parts`: what stands at the node and, if it is of depth 1, above it. The first tree says what belongs to a depth.
    int part_of(int depth, const std::vector<int>& parts) {
        const auto known = part_of_depth_.find(depth);
        if (known != part_of_depth_.end()) return known->second;
        Part part;
        part.rule = rule_index_;
        part.count = depth;
        std::size_t next = 0;
        for (const Child& member : rule_.members) part.children.push_back({parts[next++], member.pose});
        for (const Similarity& step : rule_.steps) {
            if (depth > 1) {
                const int above = part_of_depth_.at(depth - 1);
                part.children.push_back({above, step * inverse(state_.part(above).node)});
            } else {
                for (const Child& leaf : rule_.leaves) part.children.push_back({parts[next++], step * leaf.pose});
            }
        }
        centre(part);
        const PoseTolerance& tolerance = state_.tolerance;
        const int index = static_cast<int>(state_.rules.parts.size());
        state_.rules.parts.push_back(completed_part(state_.rules, std::move(part), guard_slack * tolerance.size,
                                                    guard_slack * tolerance.angle));
        state_.members.emplace_back();
        state_.costs.emplace_back();
        return part_of_depth_[depth] = index;
    }

    /// From the node's frame to the part's: origin at the mean, the first child unturned and unscaled.
    static void centre(Part& part) {
        const Similarity& first = part.children.front().pose;
        part.node = inverse(Similarity{first.linear, {}, first.mirrored});
        Point mean;
        for (const Child& child : part.children) mean += apply(part.node, child.pose.translation);
        part.node.translation = -(mean / static_cast<double>(part.children.size()));
        for (Child& child : part.children) child.pose = part.node * child.pose;
    }

    int new_item(int part, const Similarity& frame, std::vector<int> members) {
        Item item;
        item.part = part;
        item.pose = frame * inverse(state_.part(item.part).node);
        item.first = std::numeric_limits<int>::max();
        for (const int member : members) {
            if (member < 0) continue;
            item.first = std::min(item.first, state_.item(member).first);
            item_at(member).alive = false;
            touched_.insert(state_.item(member).part);
        }
        touched_.insert(item.part);
        item.members = std::move(members);
        const int index = static_cast<int>(state_.rules.items.size());
        state_.members[static_cast<std::size_t>(item.part)].push_back(index);
        state_.rules.items.push_back(std::move(item));
        return index;
    }
};

}  // namespace

SearchState with_branch_items(SearchState state, const Rule& rule, const std::vector<BranchTree>& trees) {
    TreeBuilder builder(state, rule);
    for (const BranchTree& tree : trees) builder.item_of(tree, 0, tree.depth);
    refresh(state, {builder.touched().begin(), builder.touched().end()});
    return state;
}

}  // namespace rinceau
