#pragma once
// Self-similar drawings in the order in which they were drawn (docs/analysis.md, 4.8): k blocks of equal length that are
// copies of each other, level by level, under one rule.

#include <optional>
#include <vector>

#include "analyzer/branch_items.h"
#include "analyzer/search_state.h"

namespace rinceau {

struct SelfSimilarity {
    Rule rule;  ///< kind branch, without members: R(m) -> [T1 R(m-1)] .. [Tk R(m-1)], R(0) -> one item
    std::vector<BranchTree> trees;
    double saved_bits = 0;
};

/// The rule that saves most among those that runs of consecutive items of the part follow, if there is one.
std::optional<SelfSimilarity> find_self_similarity(const SearchState& state, int part);

}  // namespace rinceau
