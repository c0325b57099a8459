#pragma once
// Parts of the plane on a raster, for what is measured of them that needs no exact outline.

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/box.h"
#include "scene/painted_region.h"

namespace rinceau {

/// A cell belongs to the mask if its middle does.
struct Mask {
    Point low;        ///< outer corner of the first cell
    double cell = 1;  ///< scene length
    int columns = 0, rows = 0;
    std::vector<std::uint8_t> inside;  ///< 0 or 1, row by row from low.y

    friend bool operator==(const Mask&, const Mask&) = default;
};

/// Cells over the box, about `cells` in all, none of them inside. The box has an area.
Mask empty_mask(const Box& box, std::size_t cells);

/// The cell of the mask that p lies in; -1 if p lies beside the mask.
std::ptrdiff_t cell_at(const Mask& mask, Point p);
bool contains(const Mask& mask, Point p);
Point cell_center(const Mask& mask, std::size_t cell);
double area(const Mask& mask);

/// The mask and what the region encloses.
Mask with_region(Mask mask, const Region& region);

/// Distance of each cell's middle to the nearest cell outside, all that lies beside the mask being outside; 0 outside.
std::vector<double> depths(const Mask& mask);

/// How much of a mask its copy covers that is moved by some cells.
struct SelfOverlap {
    int columns = 0, rows = 0;   ///< steps reach from -columns to columns, -rows to rows
    std::vector<double> shared;  ///< in cells, row by row from the lowest step

    double at(int column, int row) const {
        return shared[static_cast<std::size_t>(row + rows) * static_cast<std::size_t>(2 * columns + 1) +
                      static_cast<std::size_t>(column + columns)];
    }
};

/// For all steps up to the given ones. `wrapped`: what is moved out at one side comes in at the other; values are those of
/// a mask of real numbers. Precondition: values.size() == columns * rows; when wrapped, the steps are less than the mask.
SelfOverlap self_overlap(std::span<const double> values, int columns, int rows, int column_steps, int row_steps,
                         bool wrapped);

}  // namespace rinceau
