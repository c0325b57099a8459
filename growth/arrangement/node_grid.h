#pragma once
// Where the nodes of an arrangement stand: what is near a point, in a time that does not depend on how many there are.

#include <cmath>
#include <cstdint>
#include <vector>

#include "geometry/index_map.h"
#include "geometry/point.h"

namespace rinceau {

/// Square cells in blocks; only blocks that hold something are kept, so that the plane has no edge. A value.
class NodeGrid {
  public:
    /// `cell` > 0 should be about the distance of neighbours.
    explicit NodeGrid(double cell = 1) : cell_(cell) {}

    double cell() const { return cell_; }
    /// A node that is not in the grid.
    void insert(int node, Point at);
    void move(int node, Point to);
    void remove(int node);

    /// Calls visit(node, where) for every node at most `radius` from `center`, in an order that is the same whenever the
    /// same was done to the grid before.
    template <class Visit>
    void visit(Point center, double radius, Visit&& visit_node) const {
        const CellIndex low = cell_of(center - Point{radius, radius});
        const CellIndex high = cell_of(center + Point{radius, radius});
        const double squared = radius * radius;
        // More cells than nodes: it is quicker to look at all of them.
        if (static_cast<double>(high.x - low.x + 1) * static_cast<double>(high.y - low.y + 1) >
            4.0 * static_cast<double>(entries_.size())) {
            for (std::size_t i = 0; i < entries_.size(); ++i)
                if (entries_[i].slot >= 0 && norm(entries_[i].at - center) <= squared)
                    visit_node(static_cast<int>(i), entries_[i].at);
            return;
        }
        std::int64_t block_x = 0;
        std::int64_t block_y = 0;
        int block = unknown;
        for (std::int64_t y = low.y; y <= high.y; ++y) {
            for (std::int64_t x = low.x; x <= high.x; ++x) {
                if (block == unknown || (x >> block_bits) != block_x || (y >> block_bits) != block_y) {
                    block_x = x >> block_bits;
                    block_y = y >> block_bits;
                    block = blocks_.find(block_key({x, y}));
                }
                if (block < 0) continue;
                for (int i = heads_[slot_in(block, {x, y})]; i >= 0; i = entries_[static_cast<std::size_t>(i)].next) {
                    const Entry& entry = entries_[static_cast<std::size_t>(i)];
                    if (norm(entry.at - center) <= squared) visit_node(i, entry.at);
                }
            }
        }
    }

  private:
    struct CellIndex {
        std::int64_t x = 0, y = 0;
    };
    struct Entry {
        Point at;
        int next = -1, previous = -1;
        int slot = -1;  // of heads_; -1 = not in the grid
    };
    static constexpr int block_bits = 3;
    static constexpr int unknown = -2;

    CellIndex cell_of(Point p) const {
        // Far out cells are shared: slower, not wrong.
        constexpr double far = 1e9;
        const auto index = [&](double v) {
            return static_cast<std::int64_t>(std::floor(std::fmin(std::fmax(v / cell_, -far), far)));
        };
        return {index(p.x), index(p.y)};
    }
    static std::uint64_t block_key(CellIndex c) {
        return (static_cast<std::uint64_t>(c.x >> block_bits) << 32U) ^
               (static_cast<std::uint64_t>(c.y >> block_bits) & 0xFFFFFFFFU);
    }
    static std::size_t slot_in(int block, CellIndex c) {
        constexpr std::int64_t mask = (1 << block_bits) - 1;
        return (static_cast<std::size_t>(block) << (2 * block_bits)) +
               static_cast<std::size_t>(((c.y & mask) << block_bits) + (c.x & mask));
    }
    int slot_for(Point p);
    void unhook(int node);
    void hook(int node, int slot);

    double cell_;
    IndexMap blocks_;             // block -> number
    std::vector<int> heads_;      // first node of each cell, block after block
    std::vector<Entry> entries_;  // by node
};

}  // namespace rinceau
