// The Euclidean distance transform of P. Felzenszwalb and D. Huttenlocher ("Distance transforms of sampled functions",
// 2012): distances along columns by two sweeps, then along every row the lower envelope of parabolas.

#include "growth/aggregate/distance_transform.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rinceau {
namespace {

constexpr float unreached = std::numeric_limits<float>::infinity();

/// Cells along the column to the nearest marked one.
std::vector<float> column_distances(const CellMask& mask, bool wrapped) {
    const auto columns = static_cast<std::size_t>(mask.columns);
    const int rows = mask.rows;
    std::vector<float> steps(mask.marked.size());
    for (std::size_t i = 0; i < steps.size(); ++i) steps[i] = mask.marked[i] ? 0 : unreached;
    if (mask.marked.empty()) return steps;
    const auto sweep = [&](int row, int from) {
        float* to = &steps[static_cast<std::size_t>(row) * columns];
        const float* nearest = &steps[static_cast<std::size_t>(from) * columns];
        for (std::size_t x = 0; x < columns; ++x) to[x] = std::min(to[x], nearest[x] + 1);
    };
    // Around the grid, a second pass hands on what the first one knew only at its end.
    for (int pass = 0; pass < (wrapped ? 2 : 1); ++pass) {
        sweep(0, wrapped ? rows - 1 : 0);
        for (int row = 1; row < rows; ++row) sweep(row, row - 1);
        sweep(rows - 1, wrapped ? 0 : rows - 1);
        for (int row = rows - 1; row-- > 0;) sweep(row, row + 1);
    }
    return steps;
}

/// Lower envelope of the parabolas height[i] + (x - i)^2: row by row, so that its vectors are made once.
class Envelope {
  public:
    explicit Envelope(std::size_t count) : center_(count), start_(count + 1), half_inverse_(count) {
        for (std::size_t i = 1; i < count; ++i) half_inverse_[i] = 0.5 / static_cast<double>(i);
    }

    /// `height` becomes the envelope at 0 .. count - 1.
    void lower(std::vector<double>& height) {
        std::size_t last = 0;
        bool any = false;
        for (std::size_t i = 0; i < height.size(); ++i) {
            if (height[i] > farthest) continue;
            if (!any) {
                any = true;
                put(0, i, -unbounded, height[i]);
                continue;
            }
            double from = crossing(last, i, height[i]);
            while (from <= start_[last]) from = crossing(--last, i, height[i]);
            put(++last, i, from, height[i]);
        }
        if (!any) return;
        start_[last + 1] = unbounded;
        read(height);
    }

  private:
    static constexpr double unbounded = std::numeric_limits<double>::infinity();
    static constexpr double farthest = std::numeric_limits<double>::max();
    struct Parabola {
        std::size_t at = 0;
        double height = 0;
    };
    void put(std::size_t k, std::size_t i, double from, double height) {
        center_[k] = {i, height};
        start_[k] = from;
    }
    /// Where parabola i begins to be lower than the k-th of the envelope, which stands before it.
    double crossing(std::size_t k, std::size_t i, double height) const {
        const Parabola& before = center_[k];
        return (height - before.height) * half_inverse_[i - before.at] + 0.5 * static_cast<double>(i + before.at);
    }
    void read(std::vector<double>& height) const {
        std::size_t k = 0;
        for (std::size_t i = 0; i < height.size(); ++i) {
            const double at = static_cast<double>(i);
            while (start_[k + 1] < at) ++k;
            const double away = at - static_cast<double>(center_[k].at);
            height[i] = center_[k].height + away * away;
        }
    }

    std::vector<Parabola> center_;
    std::vector<double> start_;
    std::vector<double> half_inverse_;  ///< 1 / (2 i)
};

}  // namespace

std::vector<float> distances_to_marked(const CellMask& mask, CellSize cell, bool wrapped) {
    std::vector<float> result = column_distances(mask, wrapped);
    const auto columns = static_cast<std::size_t>(mask.columns);
    // Around the grid, the row is doubled: its second half stands before it, its first half after it.
    const std::size_t before = wrapped ? (columns + 1) / 2 : 0, length = columns + 2 * before;
    const double stretch = cell.y / cell.x;
    std::vector<double> height(length);
    Envelope envelope(length);
    for (int row = 0; row < mask.rows; ++row) {
        float* line = &result[static_cast<std::size_t>(row) * columns];
        for (std::size_t x = 0; x < columns; ++x) {
            const double steps = stretch * static_cast<double>(line[x]);
            height[before + x] = steps * steps;
        }
        for (std::size_t x = 0; x < before; ++x) {
            height[x] = height[x + columns];
            height[before + columns + x] = height[before + x];
        }
        envelope.lower(height);
        for (std::size_t x = 0; x < columns; ++x) line[x] = static_cast<float>(cell.x * std::sqrt(height[before + x]));
    }
    return result;
}

}  // namespace rinceau
