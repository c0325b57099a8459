// Ijiri et al. 2008 let the user begin wherever something shall grow. Here the ground is laid out in cells: whatever part of
// it stays bare gets a seed of its own.

#include "growth/arrangement/grow_ground.h"

#include <algorithm>
#include <cmath>

namespace rinceau {
namespace {

constexpr double most_cells = 40'000;  // wider cells on a ground that is larger

/// Cells of the ground, and which of them have elements near.
class GroundCells {
  public:
    GroundCells(const Box& ground, double least_side) : ground_(ground) {
        side_ = std::max({least_side, std::sqrt(width(ground) * height(ground) / most_cells),
                          std::max(width(ground), height(ground)) / most_cells});
        columns_ = std::max(1, static_cast<int>(std::ceil(width(ground) / side_)));
        rows_ = std::max(1, static_cast<int>(std::ceil(height(ground) / side_)));
        covered_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_), false);
    }

    std::size_t count() const { return covered_.size(); }
    bool is_covered(std::size_t cell) const { return covered_[cell]; }
    Point middle(std::size_t cell) const {
        const auto across = static_cast<std::size_t>(columns_);
        const Point steps{static_cast<double>(cell % across) + 0.5, static_cast<double>(cell / across) + 0.5};
        return {ground_.low.x + width(ground_) * steps.x / columns_, ground_.low.y + height(ground_) * steps.y / rows_};
    }
    void cover(Point p, double radius) {
        const auto range = [radius](double at, double low, double extent, int cells) {
            const double a_unit = extent > 0 ? cells / extent : 0;
            const auto cell = [&](double x) { return static_cast<int>(std::clamp((x - low) * a_unit, -1.0, cells * 1.0)); };
            return std::pair{std::max(cell(at - radius), 0), std::min(cell(at + radius), cells - 1)};
        };
        const auto [left, right] = range(p.x, ground_.low.x, width(ground_), columns_);
        const auto [low, high] = range(p.y, ground_.low.y, height(ground_), rows_);
        for (int row = low; row <= high; ++row) {
            for (int column = left; column <= right; ++column) {
                const std::size_t cell =
                    static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(column);
                if (abs(middle(cell) - p) <= radius) covered_[cell] = true;
            }
        }
    }

  private:
    Box ground_;
    double side_ = 1;
    int columns_ = 1, rows_ = 1;
    std::vector<bool> covered_;
};

/// Cells where something may stand, those far from lines first; of the ones that are farther than `far` the middle ones.
std::vector<std::size_t> cells_in_order(const GroundCells& cells, const ArrangeSurroundings& around, Point middle,
                                        double far) {
    const Boundary none;
    const Boundary& boundary = around.boundary ? *around.boundary : none;
    std::vector<double> depths(cells.count(), 0);
    std::vector<std::size_t> order;
    for (std::size_t cell = 0; cell < cells.count(); ++cell) {
        const Point at = cells.middle(cell);
        if (!boundary.allows(at)) continue;
        const auto line = boundary.nearest(at, far);
        depths[cell] = line ? abs(*line - at) : far;
        order.push_back(cell);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        if (depths[a] != depths[b]) return depths[a] > depths[b];
        return norm(cells.middle(a) - middle) < norm(cells.middle(b) - middle);
    });
    return order;
}

}  // namespace

Point ground_start(const ArrangeSurroundings& around, const Box& ground) {
    if (!around.boundary || around.boundary->is_empty()) return center(ground);
    constexpr double cells_a_side = 64;
    const GroundCells cells(ground, diagonal(ground) / cells_a_side);
    const auto order = cells_in_order(cells, around, center(ground), diagonal(ground));
    return order.empty() ? center(ground) : cells.middle(order.front());
}

ElementArrangement grown_over(ElementArrangement arrangement, const Exemplar& exemplar, const ArrangeSurroundings& around,
                              const Box& ground, const GrowOrder& order, const Progress& progress) {
    // An element this near to a place shows that growth has come there.
    constexpr double reach = 1.5;         // of a mean edge
    constexpr double beyond_holes = 1.2;  // of the largest empty circle, which is no bare part
    const double near = std::max(reach * exemplar.mean_edge, beyond_holes * exemplar.largest_empty);
    GroundCells cells(ground, exemplar.mean_edge);
    std::size_t seen = 0;
    const auto cover_new = [&] {
        for (; seen < arrangement.nodes.size(); ++seen) {
            const ArrangementNode& node = arrangement.nodes[seen];
            if (node.reference >= 0 && !node.dead) cells.cover(node.position, near);
        }
    };
    const auto ended = [&] { return arrangement.elements >= order.count || (order.stop && order.stop()); };
    const auto grow_from = [&](Point at) {
        arrangement = with_seed(std::move(arrangement), exemplar, around, at);
        arrangement = grow(std::move(arrangement), exemplar, around, order, progress);
        cover_new();
    };
    grow_from(ground_start(around, ground));
    for (const std::size_t cell : cells_in_order(cells, around, center(ground), near)) {
        if (ended()) break;
        if (!cells.is_covered(cell)) grow_from(cells.middle(cell));
    }
    return arrangement;
}

}  // namespace rinceau
