#pragma once
// A grid whose cells hold lists: what lies near a place, in little memory.

#include <cstdint>
#include <vector>

#include "geometry/box.h"

namespace rinceau {

/// What a cell remembers: part `part` (an edge, a corner) of owner `owner`.
struct CellEntry {
    std::uint32_t owner = 0, part = 0;
};

/// Places outside of the box belong to the cells at its edge. Cells are visited in the order in which entries were added,
/// the last one first.
class CellLists {
  public:
    /// The box has an area. Cells are made wider where there would be more than `max_cells`.
    CellLists(const Box& box, double cell, std::size_t max_cells);

    int column_at(double x) const { return clamped((x - low_.x) * per_length_, columns_); }
    int row_at(double y) const { return clamped((y - low_.y) * per_length_, rows_); }
    double cell() const { return cell_; }
    double row_edge(int row) const { return low_.y + row * cell_; }

    void add(int column, int row, CellEntry entry);
    /// Takes one entry away that is equal to `entry`.
    void remove(int column, int row, CellEntry entry);

    /// Calls visit(entry) until it returns false; false if it has.
    template <class Visit>
    bool visit(int column, int row, Visit&& visit_entry) const {
        for (std::uint32_t node = first_[index(column, row)]; node != none; node = nodes_[node].next)
            if (!visit_entry(nodes_[node].entry)) return false;
        return true;
    }
    /// Calls visit(column, row) for the cells that the segment runs through (some beside it may be among them) until it
    /// returns false; false if it has.
    template <class Visit>
    bool walk(Point a, Point b, Visit&& visit_cell) const;
    /// The same for the cells that meet a box.
    template <class Visit>
    bool walk(const Box& box, Visit&& visit_cell) const {
        const int last_column = column_at(box.high.x), last_row = row_at(box.high.y);
        for (int row = row_at(box.low.y); row <= last_row; ++row)
            for (int column = column_at(box.low.x); column <= last_column; ++column)
                if (!visit_cell(column, row)) return false;
        return true;
    }

  private:
    struct ListNode {
        CellEntry entry;
        std::uint32_t next = 0;
    };
    static constexpr std::uint32_t none = 0xffffffff;

    static int clamped(double cells, int count) {
        return cells > 0 ? (cells < count ? static_cast<int>(cells) : count - 1) : 0;
    }
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    }

    Point low_;
    double cell_ = 1, per_length_ = 1;
    int columns_ = 1, rows_ = 1;
    std::vector<std::uint32_t> first_;  ///< of every cell
    std::vector<ListNode> nodes_;
    std::uint32_t free_ = none;  ///< list of nodes that are not in use
};

template <class Visit>
bool CellLists::walk(Point a, Point b, Visit&& visit_cell) const {
    if (a.y > b.y) std::swap(a, b);
    const int first_row = row_at(a.y), last_row = row_at(b.y);
    // Wide enough for every rounding below: cells are some 2^22 at most along a side, coordinates some cells from the box.
    constexpr double slack_share = 1e-6;
    const double slack = slack_share * cell_;
    const double slope = b.y > a.y ? (b.x - a.x) / (b.y - a.y) : 0;
    const double low_x = std::min(a.x, b.x), high_x = std::max(a.x, b.x);
    for (int row = first_row; row <= last_row; ++row) {
        // The rows at the edge reach outward without end.
        double from = low_x, to = high_x;
        if (first_row != last_row) {
            const double enter = row == first_row ? a.x : a.x + slope * (row_edge(row) - a.y);
            const double leave = row == last_row ? b.x : a.x + slope * (row_edge(row + 1) - a.y);
            from = std::max(low_x, std::min(enter, leave) - slack * (1 + std::abs(slope)));
            to = std::min(high_x, std::max(enter, leave) + slack * (1 + std::abs(slope)));
        }
        const int last_column = column_at(to);
        for (int column = column_at(from); column <= last_column; ++column)
            if (!visit_cell(column, row)) return false;
    }
    return true;
}

}  // namespace rinceau
