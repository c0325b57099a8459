#pragma once
// Chains of items that follow a step (Stava et al. 2010, section 5.3, "find the longest sequence"; docs/analysis.md, 4.2).
// Because the step is fixed, "next" is a partial injection on (item, gauge), so the longest chains need no search.

#include <span>
#include <vector>

#include "analyzer/pose_grid.h"
#include "analyzer/rule_model.h"

namespace rinceau {

/// Items in order, each with the frame that continues the sequence (its pose times one of its symmetries).
struct Chain {
    std::vector<int> items;  ///< -1: this one is missing, its frame says nothing
    std::vector<Similarity> frames;
    bool closed = false;
    int gauge = 0;  ///< of the first item
};

/// Chains under the constant step, from any of `sources` in any gauge; lengths >= 2. Not disjoint.
std::vector<Chain> sequence_chains(const RuleSet& rules, const PoseGrid& grid, std::span<const int> sources,
                                   const Similarity& step, const PoseTolerance& tolerance);

/// For a part without direction: its items take their heading (+y) along the step, which moves by `step.translation`
/// = (0, d), turns and scales by step.linear. `starts` are pairs of items. Lengths >= 2.
std::vector<Chain> directed_chains(const RuleSet& rules, const PoseGrid& grid, std::span<const std::pair<int, int>> starts,
                                   const Similarity& step, const PoseTolerance& tolerance);

/// Chains whose step's turn and spin grow by the rule's changes (eq. 4), each found from one of the start pairs; the
/// first step of each may differ. Lengths >= 3.
struct LinearChain {
    Chain chain;
    Similarity first_step;
};
std::vector<LinearChain> linear_chains(const RuleSet& rules, const PoseGrid& grid,
                                       std::span<const std::pair<int, int>> starts, const Rule& rule,
                                       const PoseTolerance& tolerance);

/// Disjoint chains: longest first (closed before open, in drawing order before against it), later ones cut to their
/// longest free run; where straight chains cut each other, all of one direction first if that spares cuts. If a chain of four or more exists, runs of two are left to other rules.
std::vector<Chain> claimed(const RuleSet& rules, std::vector<Chain> chains);

}  // namespace rinceau
