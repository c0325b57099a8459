#pragma once
// How far every place of a domain is from what is placed and from the border (Sakurai & Miyata 2014, section 4.2), kept up
// to date around each new region.

#include <cstddef>
#include <optional>
#include <vector>

#include "geometry/similarity.h"
#include "growth/aggregate/distance_transform.h"
#include "growth/aggregate/pack_domain.h"
#include "scene/painted_region.h"

namespace rinceau {

/// Cells [low, low + size) of both axes, not folded back into a tile.
struct CellWindow {
    int column = 0, row = 0, columns = 0, rows = 0;
};

/// Signed distances at the middles of square cells (of a tile: so nearly square that they fill it): positive where nothing
/// is, negative inside regions and outside of the domain. Off by up to about half a cell.
class DistanceField {
  public:
    /// An empty domain. Cells are `cell` wide, or wider where there would be more than `max_cells`.
    DistanceField(const PackDomain& domain, double cell, std::size_t max_cells);

    /// Forgets everything that was added.
    void clear();
    /// Adds many regions at once: time linear in the cells.
    void add_all(const std::vector<Region>& regions);
    /// Adds one region: time linear in the cells that come nearer to it than to all else. Says where values may have
    /// changed.
    CellWindow add(const Region& region);

    /// Between the middles of cells, bilinear; beyond the border it falls on.
    double at(Point p) const;
    /// The direction in which it rises there: a unit vector, or zero where none can be told.
    Point uphill(Point p) const;

    int columns() const { return columns_; }
    int rows() const { return rows_; }
    float value(int column, int row) const { return values_[index(column, row)]; }
    Point middle(int column, int row) const { return corner(column + 0.5, row + 0.5); }
    Point corner(double column, double row) const { return {low_.x + column * cell_.x, low_.y + row * cell_.y}; }
    CellSize cell() const { return cell_; }
    /// The longer side of a cell.
    double step() const { return cell_.x > cell_.y ? cell_.x : cell_.y; }
    bool is_tiled() const { return tiled_; }

  private:
    std::size_t index(int column, int row) const {
        return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
    }
    /// A point between the middles of four cells: values below and above it, how they rise to the right over one cell, and
    /// how far up from the lower to the higher pair it stands.
    struct Patch {
        double low, high, low_rise, high_rise, v;
        double beyond;  ///< how far the point is from the grid
    };
    Patch patch_at(Point p) const;
    CellMask mask_of(const Region& region, const CellWindow& window) const;
    void mark_corners(const Region& region, const CellWindow& window, CellMask& mask) const;
    CellWindow window_about(const Box& box, double margin) const;
    CellWindow clipped(CellWindow window) const;
    bool reaches_beyond(const CellWindow& window, const std::vector<float>& distances) const;
    std::vector<float> signed_distances(const CellMask& mask, bool wrapped) const;
    void mark_inside(const CellWindow& inner, const CellWindow& window, const CellMask& mask,
                     std::vector<float>& distances) const;
    std::vector<float> empty_domain(const PackDomain& domain) const;
    std::size_t folded(int column, int row) const;

    Point low_;
    CellSize cell_;
    int columns_ = 1, rows_ = 1;
    bool tiled_ = false;
    std::vector<float> empty_;  ///< of the domain with nothing in it
    std::vector<float> values_;
};

}  // namespace rinceau
