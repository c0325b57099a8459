#pragma once
// Exact Euclidean distances on a raster (Felzenszwalb & Huttenlocher 2012, "Distance transforms of sampled functions").

#include <cstdint>
#include <span>
#include <vector>

namespace rinceau {

/// For each cell of a raster, row by row, the squared distance in cells from its middle to the middle of the nearest marked
/// cell; infinite where no cell is marked. Time is proportional to the number of cells.
std::vector<double> squared_distances(std::span<const std::uint8_t> marked, int columns, int rows);

}  // namespace rinceau
