#pragma once
// Layers on a hierarchy: which nodes to raise so that one leaf comes to lie above another (docs/analysis.md, 8).

#include <vector>

namespace rinceau {

/// Nodes come after their parents; node 0 is the root. The layer of a node is the sum of the values of the variables of the
/// nodes from below the root down to it. Several nodes may share a variable.
struct LayerHierarchy {
    std::vector<int> parent{-1};
    std::vector<int> depth{0};
    std::vector<int> variable{-1};  ///< -1 = cannot be raised
    int variables = 0;
};

/// layer(upper) - layer(lower) must be at least `need`.
struct LayerDemand {
    int lower = 0;  ///< nodes
    int upper = 0;
    int need = 0;
    int pairs = 1;  ///< of elements that ask for it
};

enum class LayerDirection : unsigned char { raise, lower };

struct LayerSolution {
    std::vector<int> values;  ///< of the variables
    bool complete = true;     ///< every demand is met
};

int layer_of(const LayerHierarchy& hierarchy, const std::vector<int>& values, int node);

/// Meets the demands by raising the upper or lowering the lower of two nodes where their ways from the root part. Demands
/// that contradict others are given up, those of the fewest pairs first; work is bounded. Demands sorted by paint order of
/// their upper elements are met soonest. `give_up` = false: returns after a few sweeps with what is reached.
LayerSolution meet_demands(const LayerHierarchy& hierarchy, const std::vector<LayerDemand>& demands,
                           LayerDirection direction, bool give_up);

}  // namespace rinceau
