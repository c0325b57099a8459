// The paper computes the field anew for every round on the graphics processor. Here a region that is added changes only the
// cells that are nearer to it than to everything before, and these lie around it without a gap: a window is made larger
// until nothing changes along its sides.

#include "growth/aggregate/distance_field.h"

#include <algorithm>
#include <cmath>

namespace rinceau {
namespace {

/// Rings of cells beyond the border of a box, so that the field falls there.
constexpr int cells_beyond = 2;

int wrapped_index(int i, int count) {
    const int rest = i % count;
    return rest < 0 ? rest + count : rest;
}

}  // namespace

DistanceField::DistanceField(const PackDomain& domain, double cell, std::size_t max_cells) : tiled_(domain.tiled) {
    const Box box = domain.region ? bounds(*domain.region) : domain.box;
    const double w = width(box), h = height(box), most = static_cast<double>(max_cells);
    const double step = std::max({cell, std::sqrt(w * h / most), std::max(w, h) / most});
    columns_ = std::max(1, static_cast<int>(std::ceil(w / step)));
    rows_ = std::max(1, static_cast<int>(std::ceil(h / step)));
    cell_ = {w / columns_, h / rows_};
    low_ = box.low;
    if (!tiled_) {
        // Cells stay those of the box; more of them stand around it.
        columns_ += 2 * cells_beyond;
        rows_ += 2 * cells_beyond;
        low_ -= Point{cells_beyond * cell_.x, cells_beyond * cell_.y};
    }
    empty_ = empty_domain(domain);
    values_ = empty_;
}

std::vector<float> DistanceField::empty_domain(const PackDomain& domain) const {
    const std::size_t count = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
    // Nothing is farther from anything than this.
    if (tiled_) return std::vector<float>(count, static_cast<float>(diagonal(domain.box)));
    if (domain.region) {
        std::vector<float> values = signed_distances(mask_of(*domain.region, {0, 0, columns_, rows_}), false);
        for (float& value : values) value = -value;  // free is inside
        return values;
    }
    std::vector<float> values(count);
    for (int row = 0; row < rows_; ++row)
        for (int column = 0; column < columns_; ++column) {
            const Point p = middle(column, row), from_low = p - domain.box.low, from_high = domain.box.high - p;
            values[index(column, row)] = static_cast<float>(std::min({from_low.x, from_low.y, from_high.x, from_high.y}));
        }
    return values;
}

void DistanceField::clear() { values_ = empty_; }

/// Cells of the window whose middles lie inside, row by row between the crossings with its outline.
CellMask DistanceField::mask_of(const Region& region, const CellWindow& window) const {
    CellMask mask{window.columns, window.rows, {}};
    mask.marked.assign(static_cast<std::size_t>(window.columns) * static_cast<std::size_t>(window.rows), 0);
    std::vector<std::vector<double>> crossings(static_cast<std::size_t>(window.rows));
    const auto cells = [&](Point p) {
        return Point{(p.x - low_.x) / cell_.x - 0.5 - window.column, (p.y - low_.y) / cell_.y - 0.5 - window.row};
    };
    for (const auto& ring : region)
        for (std::size_t i = 0; i < ring.size(); ++i) {
            Point a = cells(ring[i]), b = cells(ring[i + 1 < ring.size() ? i + 1 : 0]);
            if (a.y > b.y) std::swap(a, b);
            const double last = std::min(std::ceil(b.y), static_cast<double>(window.rows));
            for (double row = std::max(std::ceil(a.y), 0.0); row < last; ++row)
                crossings[static_cast<std::size_t>(row)].push_back(a.x + (b.x - a.x) * ((row - a.y) / (b.y - a.y)));
        }
    for (std::size_t row = 0; row < crossings.size(); ++row) {
        std::vector<double>& line = crossings[row];
        std::ranges::sort(line);
        const auto first_at = [&](double x) {
            return std::clamp(static_cast<std::ptrdiff_t>(std::ceil(x)), std::ptrdiff_t{0}, std::ptrdiff_t{window.columns});
        };
        const auto begin = mask.marked.begin() + static_cast<std::ptrdiff_t>(row) * window.columns;
        for (std::size_t k = 0; k + 1 < line.size(); k += 2)
            std::fill(begin + first_at(line[k]), begin + std::max(first_at(line[k]), first_at(line[k + 1])),
                      std::uint8_t{1});
    }
    if (std::ranges::find(mask.marked, 1) == mask.marked.end()) mark_corners(region, window, mask);
    return mask;
}

/// A region that slips between the middles of cells is seen by its corners.
void DistanceField::mark_corners(const Region& region, const CellWindow& window, CellMask& mask) const {
    for (const auto& ring : region)
        for (const Point p : ring) {
            const int column = static_cast<int>(std::floor((p.x - low_.x) / cell_.x)) - window.column;
            const int row = static_cast<int>(std::floor((p.y - low_.y) / cell_.y)) - window.row;
            if (column < 0 || row < 0 || column >= window.columns || row >= window.rows) continue;
            mask.marked[static_cast<std::size_t>(row) * static_cast<std::size_t>(window.columns) +
                        static_cast<std::size_t>(column)] = 1;
        }
}

/// To the outline, which runs half a cell from the middles of the cells beside it: positive outside the mask, negative in
/// it.
std::vector<float> DistanceField::signed_distances(const CellMask& mask, bool wrapped) const {
    std::vector<float> outside = distances_to_marked(mask, cell_, wrapped);
    CellMask free = mask;
    for (std::uint8_t& marked : free.marked) marked = !marked;
    const std::vector<float> inside = distances_to_marked(free, cell_, wrapped);
    const auto half = static_cast<float>(0.5 * std::min(cell_.x, cell_.y));
    for (std::size_t i = 0; i < outside.size(); ++i) outside[i] = mask.marked[i] ? half - inside[i] : outside[i] - half;
    return outside;
}

/// The same for a region that stands within `inner`, a part of the window; outside, the distances are there already.
void DistanceField::mark_inside(const CellWindow& inner, const CellWindow& window, const CellMask& mask,
                                std::vector<float>& distances) const {
    const auto half = static_cast<float>(0.5 * std::min(cell_.x, cell_.y));
    for (float& distance : distances) distance -= half;
    const auto in_window = [&](int column, int row) {
        return static_cast<std::size_t>(inner.row - window.row + row) * static_cast<std::size_t>(window.columns) +
               static_cast<std::size_t>(inner.column - window.column + column);
    };
    CellMask free{inner.columns, inner.rows, {}};
    for (int row = 0; row < inner.rows; ++row)
        for (int column = 0; column < inner.columns; ++column) free.marked.push_back(!mask.marked[in_window(column, row)]);
    const std::vector<float> depths = distances_to_marked(free, cell_);
    for (int row = 0, i = 0; row < inner.rows; ++row)
        for (int column = 0; column < inner.columns; ++column, ++i)
            if (!free.marked[static_cast<std::size_t>(i)])
                distances[in_window(column, row)] = half - depths[static_cast<std::size_t>(i)];
}

void DistanceField::add_all(const std::vector<Region>& regions) {
    CellMask mask{columns_, rows_, std::vector<std::uint8_t>(values_.size(), 0)};
    for (const Region& region : regions) {
        const CellWindow window = window_about(bounds(region), 0);
        const CellMask one = mask_of(region, window);
        for (int row = 0; row < window.rows; ++row)
            for (int column = 0; column < window.columns; ++column)
                if (one.marked[static_cast<std::size_t>(row) * static_cast<std::size_t>(window.columns) +
                               static_cast<std::size_t>(column)])
                    mask.marked[folded(window.column + column, window.row + row)] = 1;
    }
    const std::vector<float> distances = signed_distances(mask, tiled_);
    for (std::size_t i = 0; i < values_.size(); ++i) values_[i] = std::min(values_[i], distances[i]);
}

std::size_t DistanceField::folded(int column, int row) const {
    return tiled_ ? index(wrapped_index(column, columns_), wrapped_index(row, rows_)) : index(column, row);
}

CellWindow DistanceField::window_about(const Box& box, double margin) const {
    const auto first = [](double x) { return static_cast<int>(std::floor(x)) - 1; };
    const int column = first((box.low.x - margin - low_.x) / cell_.x), row = first((box.low.y - margin - low_.y) / cell_.y);
    const int end_column = first((box.high.x + margin - low_.x) / cell_.x) + 3,
              end_row = first((box.high.y + margin - low_.y) / cell_.y) + 3;
    return clipped({column, row, end_column - column, end_row - row});
}

/// To the grid; of a tile to one turn around it, as many cells taken from both sides.
CellWindow DistanceField::clipped(CellWindow window) const {
    const auto clip = [this](int& first, int& count, int whole) {
        if (tiled_) {
            if (count <= whole) return;
            first += (count - whole) / 2;
            count = whole;
            return;
        }
        const int end = std::min(first + count, whole);
        first = std::max(first, 0);
        count = std::max(end - first, 0);
    };
    clip(window.column, window.columns, columns_);
    clip(window.row, window.rows, rows_);
    return window;
}

/// Does a cell along the sides of the window, other than the grid's own, come nearer to the region than it was to all else?
bool DistanceField::reaches_beyond(const CellWindow& window, const std::vector<float>& distances) const {
    const auto nearer = [&](int column, int row) {
        const std::size_t i =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(window.columns) + static_cast<std::size_t>(column);
        return distances[i] < values_[folded(window.column + column, window.row + row)];
    };
    const bool left = tiled_ ? window.columns < columns_ : window.column > 0;
    const bool right = tiled_ ? left : window.column + window.columns < columns_;
    const bool low = tiled_ ? window.rows < rows_ : window.row > 0;
    const bool high = tiled_ ? low : window.row + window.rows < rows_;
    for (int row = 0; row < window.rows; ++row)
        if ((left && nearer(0, row)) || (right && nearer(window.columns - 1, row))) return true;
    for (int column = 0; column < window.columns; ++column)
        if ((low && nearer(column, 0)) || (high && nearer(column, window.rows - 1))) return true;
    return false;
}

CellWindow DistanceField::add(const Region& region) {
    const Box box = bounds(region);
    CellWindow window = window_about(box, 0);
    // Deep gaps reach farther beyond the region.
    float deepest = 0;
    for (int row = 0; row < window.rows; ++row)
        for (int column = 0; column < window.columns; ++column)
            deepest = std::max(deepest, values_[folded(window.column + column, window.row + row)]);
    for (double margin = deepest;; margin = 2 * margin + step()) {
        window = window_about(box, margin);
        const CellMask mask = mask_of(region, window);
        std::vector<float> distances = distances_to_marked(mask, cell_);
        mark_inside(window_about(box, 0), window, mask, distances);
        if (reaches_beyond(window, distances)) continue;
        std::size_t i = 0;
        for (int row = 0; row < window.rows; ++row)
            for (int column = 0; column < window.columns; ++column, ++i) {
                float& value = values_[folded(window.column + column, window.row + row)];
                value = std::min(value, distances[i]);
            }
        return window;
    }
}

DistanceField::Patch DistanceField::patch_at(Point p) const {
    const double x = (p.x - low_.x) / cell_.x - 0.5, y = (p.y - low_.y) / cell_.y - 0.5;
    // Between four cells of the grid, as nearly always; or else between the nearest four, or of a tile those around its
    // side.
    double beyond = 0;
    int column = 0, row = 0;
    if (x >= 0 && y >= 0 && x < columns_ - 1 && y < rows_ - 1) {
        column = static_cast<int>(x);
        row = static_cast<int>(y);
    } else if (tiled_) {
        column = static_cast<int>(std::floor(x));
        row = static_cast<int>(std::floor(y));
    } else {
        const double near_x = std::clamp(x, 0.0, columns_ - 1.0), near_y = std::clamp(y, 0.0, rows_ - 1.0);
        beyond = abs(Point{(x - near_x) * cell_.x, (y - near_y) * cell_.y});
        column = std::min(static_cast<int>(near_x), columns_ - 2);
        row = std::min(static_cast<int>(near_y), rows_ - 2);
    }
    const double u = std::clamp(x - column, 0.0, 1.0), v = std::clamp(y - row, 0.0, 1.0);
    const double f00 = values_[folded(column, row)], f10 = values_[folded(column + 1, row)];
    const double f01 = values_[folded(column, row + 1)], f11 = values_[folded(column + 1, row + 1)];
    return {f00 + u * (f10 - f00), f01 + u * (f11 - f01), f10 - f00, f11 - f01, v, beyond};
}

double DistanceField::at(Point p) const {
    const Patch patch = patch_at(p);
    return patch.low + patch.v * (patch.high - patch.low) - patch.beyond;
}

Point DistanceField::uphill(Point p) const {
    const Patch patch = patch_at(p);
    const Point rise{(patch.low_rise + patch.v * (patch.high_rise - patch.low_rise)) / cell_.x,
                     (patch.high - patch.low) / cell_.y};
    const double length = abs(rise);
    return length > 0 ? rise / length : Point{};
}

}  // namespace rinceau
