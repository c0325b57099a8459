#pragma once
// Which of many boxes meet a given box.

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "geometry/box.h"

namespace rinceau {

/// A tree over a copy of the boxes, packed tile by tile (Leutenegger et al. 1997, sort-tile-recursive). Coordinates of boxes
/// that are not empty must be finite; empty boxes are never found. Queries may run on several threads at a time.
class BoxTree {
  public:
    BoxTree() = default;
    explicit BoxTree(std::span<const Box> boxes);

    /// Calls visit(index) for every box that meets `query` (touching counts; `query` may be unbounded), in an order that
    /// depends on the boxes alone, until visit returns false. False if visit has stopped it.
    template <class Visit>
    bool visit(const Box& query, Visit&& visit_index) const {
        return levels_.empty() || visit_node(levels_.size() - 1, 0, query, visit_index);
    }

  private:
    static constexpr std::size_t fan_out = 8;

    template <class Visit>
    bool visit_node(std::size_t level, std::size_t first, const Box& query, Visit& visit_index) const {
        const std::size_t end = std::min(first + fan_out, levels_[level].size());
        for (std::size_t i = first; i < end; ++i) {
            if (!overlap(levels_[level][i], query)) continue;
            if (!(level == 0 ? visit_index(indices_[i]) : visit_node(level - 1, i * fan_out, query, visit_index)))
                return false;
        }
        return true;
    }

    std::vector<std::size_t> indices_;      ///< of the given boxes, in the order of levels_[0]
    std::vector<std::vector<Box>> levels_;  ///< levels_[0] the boxes; node i of level k covers i * fan_out .. of level k - 1
};

}  // namespace rinceau
