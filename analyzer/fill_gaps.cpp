#include "analyzer/fill_gaps.h"

#include <algorithm>
#include <limits>
#include <set>
#include <tuple>

#include "geometry/kd_tree.h"

namespace rinceau {

namespace {

constexpr double most_growth = 2.5;  // what stands in may be this many times as large as what is missing

/// Where a member is missing.
struct Gap {
    int item = 0;
    std::size_t member = 0;
    Point place;
    double reach = 0;  ///< of what is missing, scene length
    double near = 0;   ///< how far off what stands in for it may be
    bool filled = false;
};

/// A root, or a member of one, and the gap that it could fill.
struct Candidate {
    double distance = 0;
    std::size_t gap = 0;
};

class Filling {
  public:
    explicit Filling(RuleSet& rules) : rules_(rules) {}

    void run() {
        const std::vector<int> roots = root_items(rules_);
        for (const int root : roots) collect(root, root);
        if (gaps_.empty()) return;
        std::vector<Point> places;
        for (const Gap& gap : gaps_) places.push_back(gap.place);
        const KdTree tree(places);
        std::vector<std::tuple<double, int, std::size_t>> fillings;  // (distance, root, gap)
        for (const int root : roots) {
            if (holds_gaps_.contains(root)) continue;
            for (const Candidate& c : gaps_near(tree, root)) fillings.emplace_back(c.distance, root, c.gap);
        }
        std::ranges::sort(fillings);
        for (const auto& [distance, root, gap] : fillings) {
            if (!gaps_[gap].filled && item(root).alive) fill(gap, root);
        }
        for (const int root : roots) {
            if (item(root).alive && !holds_gaps_.contains(root)) fill_with_members(tree, root);
        }
    }

  private:
    Item& item(int i) { return rules_.items[static_cast<std::size_t>(i)]; }
    const Part& part(int p) const { return rules_.parts[static_cast<std::size_t>(p)]; }

    void collect(int i, int root) {
        const Item& at = item(i);
        for (std::size_t k = 0; k < at.members.size(); ++k) {
            if (at.members[k] >= 0) {
                collect(at.members[k], root);
                continue;
            }
            const Child& child = part(at.part).children[k];
            const Similarity pose = at.pose * child.pose;
            const double reach = scale_of(pose) * part(child.part).radius;
            gaps_.push_back({i, k, pose.translation, reach, std::min(reach, 0.5 * room(at, k)), false});
            holds_gaps_.insert(root);
        }
    }

    /// Distance to the nearest other member in another place.
    double room(const Item& at, std::size_t k) const {
        constexpr double same_place = 0.1;  // of the size
        const std::vector<Child>& children = part(at.part).children;
        double nearest = std::numeric_limits<double>::infinity();
        for (const Child& other : children) {
            const double distance = abs(other.pose.translation - children[k].pose.translation);
            if (distance > same_place * scale_of(children[k].pose)) nearest = std::min(nearest, distance);
        }
        return scale_of(at.pose) * nearest;
    }

    std::vector<Candidate> gaps_near(const KdTree& tree, int i) {
        constexpr std::size_t nearest = 2;
        const Similarity& pose = item(i).pose;
        const double reach = scale_of(pose) * part(item(i).part).radius;
        std::vector<Candidate> found;
        for (const Neighbor& neighbour : tree.nearest(pose.translation, nearest)) {
            const Gap& gap = gaps_[neighbour.index];
            if (neighbour.distance <= gap.near && reach <= most_growth * gap.reach) {
                found.push_back({neighbour.distance, neighbour.index});
            }
        }
        return found;
    }

    void fill(std::size_t gap, int i) {
        gaps_[gap].filled = true;
        item(gaps_[gap].item).members[gaps_[gap].member] = i;
        item(i).alive = false;
        item(gaps_[gap].item).first = std::min(item(gaps_[gap].item).first, item(i).first);
    }

    /// A sequence is taken apart if each of its members finds a gap.
    void fill_with_members(const KdTree& tree, int root) {
        const std::vector<int> members = item(root).members;
        if (members.empty() || rules_.rules[static_cast<std::size_t>(part(item(root).part).rule)].kind == RuleKind::group) return;
        std::vector<std::size_t> chosen;
        for (const int member : members) {
            std::vector<Candidate> near = gaps_near(tree, member);
            std::erase_if(near, [&](const Candidate& c) {
                return gaps_[c.gap].filled || std::ranges::find(chosen, c.gap) != chosen.end();
            });
            if (near.empty()) return;
            chosen.push_back(near.front().gap);
        }
        item(root).alive = false;
        item(root).members.clear();
        for (std::size_t k = 0; k < members.size(); ++k) fill(chosen[k], members[k]);
    }

    RuleSet& rules_;
    std::vector<Gap> gaps_;
    std::set<int> holds_gaps_;
};

}  // namespace

RuleSet with_filled_gaps(RuleSet rules) {
    Filling(rules).run();
    return rules;
}

}  // namespace rinceau
