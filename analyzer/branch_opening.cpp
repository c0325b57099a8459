#include "analyzer/branch_opening.h"

#include "analyzer/branch_items.h"
#include "analyzer/find_branching.h"

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
        state = with_branch_items(std::move(state), rule, trees_of_single_items(*branching));
        found = true;
    }
    if (!found) return std::nullopt;
    return state;
}

}  // namespace rinceau
