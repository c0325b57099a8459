#pragma once
// How far every cell of a grid is from the nearest marked one (Sakurai & Miyata 2014, section 4.2: distance field).

#include <cstddef>
#include <cstdint>
#include <vector>

namespace rinceau {

struct CellMask {
    int columns = 0, rows = 0;
    std::vector<std::uint8_t> marked;  ///< row by row, 0 or 1
};

struct CellSize {
    double x = 1, y = 1;
};

/// Distances between the middles of cells, exact to the precision of float; of marked cells 0; infinite if none is marked.
/// With `wrapped`, the grid's left side joins its right one, and its low side its high one. Time: linear in the cells.
std::vector<float> distances_to_marked(const CellMask& mask, CellSize cell, bool wrapped = false);

}  // namespace rinceau
