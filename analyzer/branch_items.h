#pragma once
// Trees that were found in a drawing become items (Stava et al. 2010, r3 and r4).

#include <vector>

#include "analyzer/search_state.h"

namespace rinceau {

/// A node: where it stands, and the items of the rule's members there, in their order (at depth 0: of its leaves); -1 =
/// missing. Their parts may differ from depth to depth: a part (rule, depth) has what the first tree has there.
struct BranchNode {
    Similarity frame;
    std::vector<int> items;
};

/// Full to the depth: with k steps, node j's children are nodes k j + 1 .. k j + k. Nodes of depth 0 are there if the rule
/// has leaves.
struct BranchTree {
    int depth = 1;
    std::vector<BranchNode> nodes;
};

/// `trees` under the rule (kind branch) as items of parts (rule, depth), one for every subtree. Their elements and all items
/// but the roots are alive no longer.
SearchState with_branch_items(SearchState state, const Rule& rule, const std::vector<BranchTree>& trees);

}  // namespace rinceau
