#pragma once
// Which second part belongs to which first one, where several could (docs/analysis.md, 4.3).

#include <vector>

#include "analyzer/chains.h"

namespace rinceau {

/// A first and a second item that fit a group's step.
struct PairCandidate {
    double shift = 0;  ///< by which the second one misses its predicted place
    Chain pair;
};

/// Pairs without common items, nearest to the prediction first; where an item has a choice, pairs of the one direction in
/// which most candidates lie are taken if they are not fewer. In order of their first items. `ambiguity` becomes the number of
/// choices for each pair.
std::vector<Chain> claimed_pairs(const RuleSet& rules, std::vector<PairCandidate> candidates, double& ambiguity);

}  // namespace rinceau
