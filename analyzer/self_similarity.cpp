#include "analyzer/self_similarity.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

#include "analyzer/level_growth.h"

namespace rinceau {

namespace {

constexpr std::size_t most_blocks = 11;
constexpr double slack = 2;       // tolerances, as for links of chains
constexpr double leaf_slack = 3;  // ... that a leaf may miss its place under the whole rule
constexpr double rule_head_bits = 9, tree_bits = 6;
constexpr double odd_step_bits = 40;  // a mirrored or reversed copy is harder to see than another copy more

/// Fewer levels are no more than rows and columns.
std::size_t fewest_levels(std::size_t blocks) { return blocks == 2 ? 4 : blocks == 3 ? 3 : 2; }

std::size_t power(std::size_t base, std::size_t exponent) {
    std::size_t result = 1;
    for (std::size_t k = 0; k < exponent; ++k) result *= base;
    return result;
}

class RunFinder {
  public:
    RunFinder(const SearchState& state, std::span<const int> run, std::size_t blocks)
        : state_(state), run_(run), blocks_(blocks) {}

    std::optional<SelfSimilarity> find() {
        LevelCopies copies = copies_of_levels();
        if (copies.size() < fewest_levels(blocks_)) return std::nullopt;
        const Point centre = pose(run_[0]).translation;
        double extent = scale_of(pose(run_[0]));
        for (std::size_t k = 1; k < blocks_; ++k) extent = std::max(extent, abs(pose(run_[k]).translation - centre));
        std::optional<SelfSimilarity> best;
        for (const LevelGrowth& growth : level_growths(copies, centre, extent)) {
            auto similarity = rule_of(growth);
            if (similarity && (!best || similarity->saved_bits > best->saved_bits)) best = std::move(similarity);
        }
        return best;
    }

  private:
    const SearchState& state_;
    std::span<const int> run_;
    std::size_t blocks_;

    const Similarity& pose(int item) const { return state_.item(item).pose; }

    LevelCopies copies_of_levels() const {
        LevelCopies copies;
        for (std::size_t size = 1; size * blocks_ <= run_.size(); size *= blocks_) {
            std::vector<std::vector<BlockCopy>> level;
            for (std::size_t i = 1; i < blocks_; ++i) {
                level.push_back(block_copies(state_, run_.subspan(0, size), run_.subspan(i * size, size), slack));
                if (level.back().empty()) return copies;
            }
            copies.push_back(std::move(level));
        }
        return copies;
    }

    std::optional<SelfSimilarity> rule_of(const LevelGrowth& growth) const {
        SelfSimilarity found;
        const int part = state_.item(run_[0]).part;
        const int depth = static_cast<int>(growth.chosen.size());
        const Similarity base = pose(run_[0]);
        Similarity whole = base;
        for (int n = 0; n < depth; ++n) whole = growth.growth * whole;
        const Similarity shrink = inverse(base) * inverse(growth.growth) * base;
        found.rule.kind = RuleKind::branch;
        found.rule.leaves = {{part, {}}};
        found.rule.steps = {shrink};
        for (const BlockCopy& copy : growth.chosen.back()) {
            found.rule.steps.push_back(inverse(whole) * copy.map * whole * shrink);
        }
        const std::size_t size = power(blocks_, static_cast<std::size_t>(depth));
        if (!add_tree(found, growth, whole, run_.subspan(0, size), depth, false)) return std::nullopt;
        add_further_trees(found, growth, depth);
        found.saved_bits = bits_saved(found, growth, part);
        if (!(found.saved_bits > 0)) return std::nullopt;
        return found;
    }

    /// What follows the first tree: copies of it, or of a block at its beginning.
    void add_further_trees(SelfSimilarity& found, const LevelGrowth& growth, int depth) const {
        std::size_t begin = power(blocks_, static_cast<std::size_t>(depth));
        while (begin < run_.size()) {
            bool any = false;
            for (int smaller = depth; smaller >= 2 && !any; --smaller) {
                const std::size_t size = power(blocks_, static_cast<std::size_t>(smaller));
                if (begin + size > run_.size()) continue;
                const auto there = run_.subspan(begin, size);
                for (const BlockCopy& copy : block_copies(state_, run_.subspan(0, size), there, slack)) {
                    Similarity frame = pose(run_[0]);
                    for (int n = 0; n < smaller; ++n) frame = growth.growth * frame;
                    any = add_tree(found, growth, copy.map * frame, there, smaller, copy.reversed);
                    if (any) break;
                }
                if (any) begin += size;
            }
            if (!any) return;
        }
    }

    /// False if the rule does not lead to the items.
    bool add_tree(SelfSimilarity& found, const LevelGrowth& growth, const Similarity& frame, std::span<const int> items,
                  int depth, bool reversed) const {
        BranchTree tree{depth, {{frame, {}}}};
        struct Block {
            std::size_t begin = 0;
            bool reversed = false;
        };
        std::vector<Block> blocks{{0, reversed}};
        std::size_t first = 0;  // node of the level
        for (int level = depth; level > 0; --level) {
            const std::size_t size = power(blocks_, static_cast<std::size_t>(level) - 1);
            std::vector<Block> below;
            for (std::size_t k = 0; k < blocks.size(); ++k) {
                const Similarity at = tree.nodes[first + k].frame;
                for (std::size_t i = 0; i < blocks_; ++i) {
                    const bool turned =
                        i > 0 && growth.chosen[static_cast<std::size_t>(level) - 1][i - 1].reversed;
                    const std::size_t place = blocks[k].reversed ? blocks_ - 1 - i : i;
                    below.push_back({blocks[k].begin + place * size, blocks[k].reversed != turned});
                    tree.nodes.push_back({at * found.rule.steps[i], {}});
                }
            }
            first += blocks.size();
            blocks = std::move(below);
        }
        for (std::size_t k = 0; k < blocks.size(); ++k) {
            BranchNode& leaf = tree.nodes[first + k];
            const int item = items[blocks[k].begin];
            if (!stands_at(item, leaf.frame)) return false;
            leaf.items = {item};
        }
        found.trees.push_back(std::move(tree));
        return true;
    }

    bool stands_at(int item, const Similarity& predicted) const {
        const Item& there = state_.item(item);
        const Part& part = state_.part(there.part);
        const PoseTolerance& tolerance = state_.tolerance;
        if (abs(there.pose.translation - predicted.translation) > leaf_slack * tolerance.shift(scale_of(predicted), 0)) {
            return false;
        }
        return matching_gauge(part, there.pose, predicted, leaf_slack * tolerance.turn(part.radius)) >= 0;
    }

    double bits_saved(const SelfSimilarity& found, const LevelGrowth& growth, int part) const {
        double bits = -rule_head_bits;
        for (const BranchTree& tree : found.trees) {
            bits += static_cast<double>(power(blocks_, static_cast<std::size_t>(tree.depth)) - 1) * state_.cost(part).item_bits -
                    tree_bits;
        }
        for (const Similarity& step : found.rule.steps) {
            bits -= step_bits(state_, part, part, step) + (step.mirrored ? odd_step_bits : 0);
        }
        for (const BlockCopy& copy : growth.chosen.back()) bits -= copy.reversed ? odd_step_bits : 0;
        return bits;
    }
};

/// Where runs of items begin that are neighbours in the drawing's order, and the beginning of all.
std::vector<std::size_t> run_starts(const SearchState& state, const std::vector<int>& items) {
    std::vector<std::size_t> starts{0};
    for (std::size_t k = 1; k < items.size(); ++k) {
        if (state.item(items[k]).first != state.item(items[k - 1]).first + 1) starts.push_back(k);
    }
    return starts;
}

}  // namespace

std::optional<SelfSimilarity> find_self_similarity(const SearchState& state, int part) {
    constexpr std::size_t fewest_items = 16;
    const std::vector<int>& items = state.alive(part);
    std::optional<SelfSimilarity> best;
    if (items.size() < fewest_items || state.part(part).symmetry.continuous) return best;
    for (const std::size_t start : run_starts(state, items)) {
        const std::span<const int> run(items.begin() + static_cast<std::ptrdiff_t>(start), items.end());
        for (std::size_t blocks = 2; blocks <= most_blocks; ++blocks) {
            auto found = RunFinder(state, run, blocks).find();
            if (found && (!best || found->saved_bits > best->saved_bits)) best = std::move(found);
        }
    }
    return best;
}

}  // namespace rinceau
