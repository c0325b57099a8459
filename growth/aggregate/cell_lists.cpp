#include "growth/aggregate/cell_lists.h"

#include <algorithm>
#include <cmath>

namespace rinceau {

CellLists::CellLists(const Box& box, double cell, std::size_t max_cells) : low_(box.low), cell_(cell) {
    const double least_cell = std::sqrt(width(box) * height(box) / static_cast<double>(max_cells));
    // A box that is a thin strip has few rows; its columns are bounded, too.
    cell_ = std::max({cell_, least_cell, std::max(width(box), height(box)) / static_cast<double>(max_cells)});
    per_length_ = 1 / cell_;
    columns_ = std::max(1, static_cast<int>(std::ceil(width(box) / cell_)));
    rows_ = std::max(1, static_cast<int>(std::ceil(height(box) / cell_)));
    first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), none);
}

void CellLists::add(int column, int row, CellEntry entry) {
    std::uint32_t node = free_;
    if (node == none) {
        node = static_cast<std::uint32_t>(nodes_.size());
        nodes_.push_back({});
    } else {
        free_ = nodes_[node].next;
    }
    std::uint32_t& first = first_[index(column, row)];
    nodes_[node] = {entry, first};
    first = node;
}

void CellLists::remove(int column, int row, CellEntry entry) {
    std::uint32_t* link = &first_[index(column, row)];
    while (*link != none && (nodes_[*link].entry.owner != entry.owner || nodes_[*link].entry.part != entry.part))
        link = &nodes_[*link].next;
    if (*link == none) return;
    const std::uint32_t node = *link;
    *link = nodes_[node].next;
    nodes_[node].next = free_;
    free_ = node;
}

}  // namespace rinceau
