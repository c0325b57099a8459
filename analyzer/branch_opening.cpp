#include "analyzer/branch_opening.h"

#include "analyzer/branch_items.h"
#include "analyzer/find_branching.h"
#include "analyzer/fit_branch.h"
#include "analyzer/self_similarity.h"

namespace rinceau {

namespace {

std::vector<BranchTree> trees_of_single_items(const Branching& branching) {
    std::vector<BranchTree> trees;
    for (const GrownTree& grown : branching.trees) {
        BranchTree tree{grown.levels, {}};
        for (std::size_t node = 0; node < grown.items.size(); ++node) {
            tree.nodes.push_back({grown.frames[node], {grown.items[node]}});
        }
        trees.push_back(std::move(tree));
    }
    return trees;
}

/// The state with the trees as items, under the steps that fit them best.
SearchState with_trees(const SearchState& state, Rule rule, std::vector<BranchTree> trees) {
    const FittedBranch fitted = fitted_branch(state, rule, trees);
    rule.steps = fitted.steps;
    for (std::size_t t = 0; t < trees.size(); ++t) {
        trees[t].nodes.front().frame = fitted.roots[t];
        const std::size_t branches = rule.steps.size();
        for (std::size_t node = 1; node < trees[t].nodes.size(); ++node) {
            trees[t].nodes[node].frame = trees[t].nodes[(node - 1) / branches].frame * rule.steps[(node - 1) % branches];
        }
    }
    return with_branch_items(state, rule, trees);
}

}  // namespace

std::optional<SearchState> open_with_branching(const SearchState& start) {
    SearchState state = start;
    bool found = false;
    const auto parts = static_cast<int>(start.rules.parts.size());
    for (int part = 0; part < parts; ++part) {
        const auto branching = find_branching(state, part);
        if (!branching) continue;
        Rule rule;
        rule.kind = RuleKind::branch;
        rule.members = {{part, {}}};
        rule.steps = branching->steps;
        state = with_trees(state, rule, trees_of_single_items(*branching));
        found = true;
    }
    if (!found) return std::nullopt;
    return state;
}

std::optional<SearchState> open_with_self_similarity(const SearchState& start) {
    std::optional<SearchState> opened;
    const auto parts = static_cast<int>(start.rules.parts.size());
    for (int part = 0; part < parts; ++part) {
        const SearchState& state = opened ? *opened : start;
        const auto found = find_self_similarity(state, part);
        if (found) opened = with_trees(state, found->rule, found->trees);
    }
    return opened;
}

}  // namespace rinceau
