#pragma once
// Layers that rise or fall along a sequence: one z(k) before a production's call of itself (docs/analysis.md, 8).

#include <vector>

#include "analyzer/derivation_tree.h"
#include "lsystem/grammar.h"

namespace rinceau {

/// Leaf `lower` must be painted before leaf `upper`; both count in order of derivation.
struct LeafPair {
    int lower = 0;
    int upper = 0;
};

/// The grammar with z(k), k = -2 .. 2, in those repeating productions where it brings most pairs into order; unchanged if it
/// cannot halve what is wrong. `leaves` and `tree` as derived from the grammar.
Grammar with_repetition_layers(const Grammar& grammar, const std::vector<Placement>& leaves, const DerivationTree& tree,
                               const std::vector<LeafPair>& pairs);

}  // namespace rinceau
