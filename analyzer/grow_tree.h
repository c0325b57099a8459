#pragma once
// Trees in a drawing under given steps (Stava et al. 2010, r3): a node's children stand where the steps lead from its frame.

#include <optional>
#include <span>
#include <vector>

#include "analyzer/pose_grid.h"
#include "analyzer/search_state.h"

namespace rinceau {

/// All levels are full: with k steps, node j's children are nodes k j + 1 .. k j + k.
struct GrownTree {
    int levels = 0;                  ///< 1 = the root alone
    std::vector<int> items;          ///< by node, level by level
    std::vector<Similarity> frames;  ///< pose of the node's item times one of its symmetries
};

/// Number of nodes of a full tree.
std::size_t nodes_of_tree(std::size_t steps, int levels);

/// The pose among the equivalent ones of an item that stands where `predicted` says; one without direction takes the
/// predicted angle.
Similarity matched_frame(const SearchState& state, const PoseMatch& match, const Similarity& predicted);

class TreeGrower {
  public:
    /// Trees of items in the grid. Marks items as not alive while they are in a tree, therefore a reference.
    TreeGrower(SearchState& state, const PoseGrid& grid, const PoseTolerance& tolerance)
        : state_(&state), grid_(&grid), tolerance_(tolerance) {}

    /// The largest full tree from this item in this frame, of at most `most_nodes` nodes. Each item stands for one node.
    GrownTree grow(int root, const Similarity& frame, std::span<const Similarity> steps, std::size_t most_nodes);

    /// From now on these items belong to a tree, and no other tree takes them.
    void claim(const GrownTree& tree);

  private:
    void set_alive(std::span<const int> items, bool alive);

    SearchState* state_;
    const PoseGrid* grid_;
    PoseTolerance tolerance_;
};

}  // namespace rinceau
