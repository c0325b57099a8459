#pragma once
// Random places in gaps, the deeper the likelier (Sakurai & Miyata 2014, section 4.2).

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/random.h"
#include "growth/aggregate/distance_field.h"

namespace rinceau {

/// Draws cells with a probability that goes with the 16th power of their value in a field, at any time of the values that it
/// was told of last. A draw and an update cost the logarithm of the number of cells.
class GapSampler {
  public:
    /// Cells with a value up to `least` are never drawn. `clearance` is taken off the value of every cell first; empty =
    /// none.
    GapSampler(const DistanceField& field, double least, std::vector<float> clearance = {});

    /// The field has changed everywhere, or within a window.
    void update(const DistanceField& field);
    void update(const DistanceField& field, const CellWindow& window);

    /// A point somewhere in the cell that is drawn; none if no cell has a value above the least.
    std::optional<Point> draw(const DistanceField& field, Random& random) const;

    /// Chance of a cell to be drawn, relative to the others.
    double weight(const DistanceField& field, int column, int row) const;

  private:
    void update_blocks(const DistanceField& field, int first_column, int end_column, int first_row, int end_row);
    CellWindow cell_of(const DistanceField& field, int block, double rest) const;
    double block_weight(const DistanceField& field, int block_column, int block_row) const;

    double least_ = 0;
    std::vector<float> clearance_;
    int block_columns_ = 0, block_rows_ = 0;
    std::size_t leaves_ = 1;    ///< a power of 2
    std::vector<double> sums_;  ///< a binary tree: node i is the sum of 2 i and 2 i + 1; leaf k of the blocks is leaves_ + k
};

}  // namespace rinceau
