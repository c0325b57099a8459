#pragma once
// The steps of a branching rule by least squares over all nodes of its trees, then natural values where they fit as well.

#include "analyzer/branch_items.h"

namespace rinceau {

struct FittedBranch {
    std::vector<Similarity> steps;
    std::vector<Similarity> roots;  ///< frame of each tree's lowest node
};

/// From the steps and root frames that the rule and the trees have as a first guess. Places and outlines of all items count
/// alike, whatever their size: drawings round coordinates.
FittedBranch fitted_branch(const SearchState& state, const Rule& rule, const std::vector<BranchTree>& trees);

}  // namespace rinceau
