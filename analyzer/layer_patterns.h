#pragma once
// Layers that follow the counter of a repeating production: z(4*m - 16) instead of an exception for each module
// (docs/analysis.md, 8).

#include <vector>

#include "analyzer/derivation_tree.h"
#include "lsystem/grammar.h"

namespace rinceau {

struct LayerPattern {
    int site = 0;           ///< index into DerivationTree::sites; its bracket ends behind the module
    Expression by;          ///< in the counter of the site's production
    std::vector<int> rest;  ///< by node of the site, in their order: what is still to be added to the layer
};

/// For sites where that leaves less to be said one by one. `layers`: by node, what each module is to be raised by.
std::vector<LayerPattern> layer_patterns(const Grammar& grammar, const std::vector<Placement>& leaves, const DerivationTree& tree,
                                         const std::vector<std::vector<int>>& nodes_of_site, const std::vector<int>& layers);

}  // namespace rinceau
