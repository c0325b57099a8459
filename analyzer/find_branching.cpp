// Stava et al. 2010 cluster the transformations of all pairs, and look for branching in pairs of clusters. Here a few items
// are tried as inner nodes: their children are among their neighbours of each size, and each step must hold at many items.
// The set of steps is the one under which full trees grow largest.
#include "analyzer/find_branching.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "geometry/kd_tree.h"

namespace rinceau {

namespace {

constexpr std::size_t seeds_tried = 16;      // half of them the largest items, where trees begin
constexpr std::size_t neighbours_asked = 12;  // in each half octave of size
constexpr std::size_t samples_asked = 64;
constexpr std::size_t samples_at_first = 12;  // a step that holds at none of them is dropped
constexpr std::size_t steps_kept = 16;
constexpr std::size_t most_steps = 8;
constexpr std::size_t most_variants = 96;
constexpr std::size_t trial_nodes = 127;  // of the trees that compare pairs of steps
constexpr int fewest_levels = 3;
constexpr double smallest_scale = 1.0 / 32, largest_scale = 1.05;
constexpr double rule_head_bits = 9, tree_bits = 6;
constexpr double link_slack = 2;          // as in chains: accepted at twice the tolerance
constexpr double false_alarm_bits = -12;  // expected chance findings, as a power of two

double log2_of(double value) { return std::log2(std::max(1.0, value)); }

struct Candidate {
    Similarity step;
    int hits = 0;
};

struct StepSet {
    std::vector<Similarity> steps;
    std::size_t nodes = 0;
    double bits = 0;  ///< of the steps
};

bool better(const StepSet& a, const StepSet& b) { return a.nodes != b.nodes ? a.nodes > b.nodes : a.bits < b.bits; }

class Finder {
  public:
    Finder(SearchState& state, int part)
        : state_(state),
          part_(part),
          items_(state.alive(part)),
          grid_(state.rules, part, items_),
          tolerance_{link_slack * state.tolerance.size, link_slack * state.tolerance.angle, state.tolerance.per_distance},
          grower_(state, grid_, tolerance_) {
        by_size_ = items_;
        std::ranges::stable_sort(by_size_, std::greater<>{}, [&](int i) { return scale_of(pose(i)); });
    }

    std::optional<Branching> run() {
        make_size_classes();
        std::optional<Branching> best;
        for (const int seed : spread(by_size_, seeds_tried)) {
            const StepSet set = best_steps(seed);
            if (set.steps.empty()) continue;
            Branching branching = forest(set);
            if (branching.saved_bits > 0 && (!best || branching.saved_bits > best->saved_bits)) best = std::move(branching);
            // The larger part of the items is explained: other seeds will say the same.
            constexpr double most = 0.5;
            if (best && nodes_of(*best) > most * static_cast<double>(items_.size())) break;
        }
        return best;
    }

  private:
    SearchState& state_;
    int part_;
    std::vector<int> items_;
    PoseGrid grid_;
    PoseTolerance tolerance_;
    TreeGrower grower_;
    std::vector<int> by_size_;  // largest first
    struct SizeClass {
        double log_scale = 0;
        std::vector<int> items;
        std::unique_ptr<KdTree> tree;
    };
    std::vector<SizeClass> size_classes_;

    const Similarity& pose(int item) const { return state_.item(item).pose; }
    const std::vector<Similarity>& gauges() const { return state_.part(part_).symmetry.elements; }

    /// Half of them from the front, half spread over all.
    static std::vector<int> spread(const std::vector<int>& items, std::size_t count) {
        if (items.size() <= count) return items;
        const auto front = static_cast<std::ptrdiff_t>(count / 2);
        std::vector<int> chosen(items.begin(), items.begin() + front);
        const std::size_t stride = items.size() / (count - count / 2);
        for (std::size_t k = count / 2; k < items.size(); k += stride) chosen.push_back(items[k]);
        return chosen;
    }

    void make_size_classes() {
        std::map<int, std::vector<int>> classes;
        for (const int i : by_size_) classes[static_cast<int>(std::lround(2 * std::log2(scale_of(pose(i)))))].push_back(i);
        for (auto& [half_octaves, items] : classes) {
            std::vector<Point> origins;
            for (const int i : items) origins.push_back(pose(i).translation);
            size_classes_.push_back({0.5 * half_octaves, std::move(items), std::make_unique<KdTree>(origins)});
        }
    }

    std::vector<int> neighbours(int seed) const {
        std::vector<int> found;
        const double own = std::log2(scale_of(pose(seed)));
        // Drawings of one size have all their branches in one class.
        const std::size_t asked = std::max(neighbours_asked, 4 * neighbours_asked / size_classes_.size());
        for (const SizeClass& size_class : size_classes_) {
            if (size_class.log_scale > own + 0.5 || size_class.log_scale < own + std::log2(smallest_scale)) continue;
            for (const Neighbor& near : size_class.tree->nearest(pose(seed).translation, asked)) {
                const int item = size_class.items[near.index];
                const double scale = scale_of(pose(item)) / scale_of(pose(seed));
                if (item != seed && scale >= smallest_scale && scale <= largest_scale) found.push_back(item);
            }
        }
        return found;
    }

    bool holds_at(int item, const Similarity& step) const {
        return std::ranges::any_of(gauges(), [&](const Similarity& gauge) {
            const Similarity predicted = pose(item) * gauge * step;
            const auto match = grid_.find(predicted, abs(predicted.translation - pose(item).translation), tolerance_);
            return match && match->item != item;
        });
    }

    /// At how many of the samples the step leads to an item; 0 if at none of the first.
    int hits(const Similarity& step, const std::vector<int>& samples) const {
        int count = 0;
        for (std::size_t k = 0; k < samples.size(); ++k) {
            if (k == samples_at_first && count == 0) return 0;
            count += holds_at(samples[k], step) ? 1 : 0;
        }
        return count;
    }

    std::vector<Candidate> candidates(int seed) const {
        std::vector<int> samples = spread(by_size_, samples_asked);
        std::vector<Candidate> found;
        for (const int item : neighbours(seed)) {
            const Similarity step = inverse(pose(seed)) * pose(item);
            const int count = hits(step, samples);
            if (count >= 2) found.push_back({step, count});
        }
        std::ranges::stable_sort(found, std::greater<>{}, &Candidate::hits);
        const std::size_t most = std::min(steps_kept, std::max<std::size_t>(4, most_variants / gauges().size()));
        if (found.size() > most) found.resize(most);
        return found;
    }

    /// All nodes in full levels, or 0 if there are too few levels.
    std::size_t nodes_from(int seed, const std::vector<Similarity>& steps, std::size_t most_nodes) {
        const GrownTree tree = grower_.grow(seed, pose(seed), steps, most_nodes);
        return tree.levels >= fewest_levels ? tree.items.size() : 0;
    }

    double bits_of(const Similarity& step) const { return step_bits(state_, part_, part_, step); }

    StepSet best_steps(int seed) {
        std::vector<Similarity> variants;
        for (const Candidate& candidate : candidates(seed)) {
            for (const Similarity& gauge : gauges()) variants.push_back(candidate.step * gauge);
        }
        StepSet best;
        for (std::size_t i = 0; i < variants.size(); ++i) {
            for (std::size_t j = i + 1; j < variants.size(); ++j) {
                const StepSet pair = with_nodes(seed, {variants[i], variants[j]}, trial_nodes);
                if (pair.nodes > 0 && better(pair, best)) best = pair;
            }
        }
        if (!best.steps.empty()) best = with_nodes(seed, best.steps, items_.size());
        while (!best.steps.empty() && best.steps.size() < most_steps) {
            StepSet larger;
            for (const Similarity& variant : variants) {
                std::vector<Similarity> steps = best.steps;
                steps.push_back(variant);
                const StepSet set = with_nodes(seed, std::move(steps), items_.size());
                if (set.nodes > 0 && better(set, larger)) larger = set;
            }
            if (larger.nodes <= best.nodes) break;
            best = larger;
        }
        return best;
    }

    StepSet with_nodes(int seed, std::vector<Similarity> steps, std::size_t most_nodes) {
        StepSet set{std::move(steps), 0, 0};
        set.nodes = nodes_from(seed, set.steps, most_nodes);
        if (set.nodes > 0) {
            for (const Similarity& step : set.steps) set.bits += bits_of(step);
        }
        return set;
    }

    static double nodes_of(const Branching& branching) {
        double nodes = 0;
        for (const GrownTree& tree : branching.trees) nodes += static_cast<double>(tree.items.size());
        return nodes;
    }

    /// All trees that these steps make, deepest first, and what they save.
    Branching forest(const StepSet& set) {
        Branching branching{part_, set.steps, {}, 0};
        branching.trees = trees_of(branching.steps);
        branching.steps = refined(branching);
        std::vector<GrownTree> again = trees_of(branching.steps);
        branching.trees = std::move(again);
        const double steps = static_cast<double>(branching.steps.size()), trees = static_cast<double>(branching.trees.size());
        const double links = nodes_of(branching) - trees;
        branching.saved_bits = links * state_.cost(part_).item_bits - rule_head_bits - trees * tree_bits;
        for (const Similarity& step : branching.steps) branching.saved_bits -= bits_of(step);
        const double found_by_chance = log2_of(static_cast<double>(seeds_tried * most_variants)) * (1 + steps) +
                                       trees * log2_of(static_cast<double>(items_.size())) -
                                       (links - steps) * std::min(coincidence_bits(), seen_coincidence_bits(branching));
        if (found_by_chance > false_alarm_bits) branching.saved_bits = 0;
        return branching;
    }

    /// How unlikely it is that one link finds an item by chance.
    double coincidence_bits() const {
        const double looked = 2 * std::log2(link_slack);  // an area that is larger than the tolerance by the slack
        return std::max(1.0, state_.cost(part_).item_bits - looked - log2_of(static_cast<double>(items_.size())));
    }

    /// The same as the drawing shows it: how often the steps lead to an item from where no tree says so. On a lattice of
    /// strokes they often do.
    double seen_coincidence_bits(const Branching& branching) const {
        std::vector<char> inner(state_.rules.items.size(), 0);
        for (const GrownTree& tree : branching.trees) {
            const std::size_t nodes = nodes_of_tree(branching.steps.size(), tree.levels - 1);
            for (std::size_t node = 0; node < nodes; ++node) inner[static_cast<std::size_t>(tree.items[node])] = 1;
        }
        std::vector<int> others;
        std::ranges::copy_if(by_size_, std::back_inserter(others), [&](int i) { return !inner[static_cast<std::size_t>(i)]; });
        double found = 0, asked = 1;
        for (const int item : spread(others, samples_asked)) {
            for (const Similarity& step : branching.steps) {
                found += holds_at(item, step) ? 1 : 0;
                ++asked;
            }
        }
        return found > 0 ? -std::log2(found / asked) : HUGE_VAL;
    }

    std::vector<GrownTree> trees_of(const std::vector<Similarity>& steps) {
        std::vector<GrownTree> trees;
        for (const int item : by_size_) {
            GrownTree best;
            for (const Similarity& gauge : gauges()) {
                GrownTree tree = grower_.grow(item, pose(item) * gauge, steps, items_.size());
                if (tree.levels > best.levels) best = std::move(tree);
            }
            if (best.levels > 1) trees.push_back(std::move(best));
        }
        std::ranges::stable_sort(trees, std::greater<>{}, &GrownTree::levels);
        std::vector<GrownTree> kept;
        for (const GrownTree& tree : trees) {
            const bool free = std::ranges::all_of(tree.items, [&](int i) { return state_.item(i).alive; });
            if (!free || !worth_it(tree, kept.empty())) continue;
            grower_.claim(tree);
            kept.push_back(tree);
        }
        for (const int item : items_) state_.rules.items[static_cast<std::size_t>(item)].alive = true;
        return kept;
    }

    /// The first tree shows the rule; further ones must be no chance by themselves.
    bool worth_it(const GrownTree& tree, bool first) const {
        if (first) return tree.levels >= fewest_levels;
        const double links = static_cast<double>(tree.items.size()) - 1;
        return log2_of(static_cast<double>(items_.size())) - links * coincidence_bits() < false_alarm_bits;
    }

    /// Means over all links, those of large items weighing more: their places say more about what they carry.
    std::vector<Similarity> refined(const Branching& branching) const {
        const std::size_t branches = branching.steps.size();
        std::vector<Similarity> means;
        for (std::size_t k = 0; k < branches; ++k) {
            Similarity sum{{0, 0}, {}, branching.steps[k].mirrored};
            double weights = 0;
            for (const GrownTree& tree : branching.trees) {
                for (std::size_t node = 0; branches * node + 1 + k < tree.frames.size(); ++node) {
                    const Similarity& from = tree.frames[node];
                    const Similarity step = inverse(from) * tree.frames[branches * node + 1 + k];
                    const double weight = norm(from.linear);
                    sum.linear += weight * step.linear;
                    sum.translation += weight * step.translation;
                    weights += weight;
                }
            }
            if (!(weights > 0)) return branching.steps;
            means.push_back({sum.linear / weights, sum.translation / weights, sum.mirrored});
        }
        return means;
    }
};

/// Trees need children that are turned or smaller: items of one size and angle form none.
bool may_branch(const SearchState& state, int part) {
    const std::vector<int>& items = state.alive(part);
    if (items.size() < fewest_items_of_tree || state.part(part).symmetry.continuous) return false;
    const PartCost& cost = state.cost(part);
    return cost.scale_bits > 0 || cost.angle_bits > 0;
}

}  // namespace

std::optional<Branching> find_branching(SearchState& state, int part) {
    if (!may_branch(state, part)) return std::nullopt;
    return Finder(state, part).run();
}

}  // namespace rinceau
