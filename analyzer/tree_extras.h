#pragma once
// What a tree carries beside the item at each node: further items at every node, and items at its ends (Stava et al. 2010,
// r4).

#include "analyzer/branch_items.h"

namespace rinceau {

struct TreesOfRule {
    Rule rule;
    std::vector<BranchTree> trees;
};

/// Adds members that stand at the same place of all nodes but a few, and leaves that stand at the same place where the
/// highest nodes would branch once more. `trees` have one item a node and no leaves.
TreesOfRule with_extras(const SearchState& state, TreesOfRule found);

}  // namespace rinceau
