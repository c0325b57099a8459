#pragma once
// Branching rules (Stava et al. 2010, r3): steps under which items of a part form full trees (docs/analysis.md, 4.7).

#include <optional>
#include <vector>

#include "analyzer/grow_tree.h"

namespace rinceau {

struct Branching {
    int part = 0;
    std::vector<Similarity> steps;  ///< two or more
    std::vector<GrownTree> trees;   ///< deepest first
    double saved_bits = 0;
};

/// Two branches, three levels.
constexpr std::size_t fewest_items_of_tree = 7;

/// The branching of this part's items that saves most, if one saves more than it costs and is no chance. The items' state is
/// as it was when this returns.
std::optional<Branching> find_branching(SearchState& state, int part);

}  // namespace rinceau
