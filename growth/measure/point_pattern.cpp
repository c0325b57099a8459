// The window of a pattern is a morphological closing of its points, widened until its area is that of as many points inside:
// densities and correlations then do not depend on the pattern's size and shape.

#include "growth/measure/point_pattern.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "geometry/delaunay.h"
#include "growth/aggregate/distance_transform.h"

namespace rinceau {
namespace {

constexpr double closing = 1.5;  ///< radius in spacings
/// How deep within the closing the middle of a triangle lies that counts, in spacings: those at the rim are slivers.
constexpr double triangle_depth = 0.2;
constexpr double cells_a_spacing = 16;  ///< fine enough that areas of small exemplars are right to 1 %
constexpr std::size_t most_cells = 1'000'000;
constexpr std::size_t tile_cells = 40'000;  ///< a tile's window only bounds lags: its cells need not be fine

/// Cells that cannot be reached from the rim of the mask through cells outside.
Mask without_holes(Mask mask) {
    std::vector<std::uint8_t> open(mask.inside.size());
    std::vector<std::size_t> waiting;
    const auto reach = [&](int column, int row) {
        if (column < 0 || row < 0 || column >= mask.columns || row >= mask.rows) return;
        const auto cell =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(mask.columns) + static_cast<std::size_t>(column);
        if (mask.inside[cell] != 0 || open[cell] != 0) return;
        open[cell] = 1;
        waiting.push_back(cell);
    };
    for (int column = 0; column < mask.columns; ++column) reach(column, 0), reach(column, mask.rows - 1);
    for (int row = 0; row < mask.rows; ++row) reach(0, row), reach(mask.columns - 1, row);
    while (!waiting.empty()) {
        const auto width = static_cast<std::size_t>(mask.columns);
        const int column = static_cast<int>(waiting.back() % width), row = static_cast<int>(waiting.back() / width);
        waiting.pop_back();
        reach(column - 1, row), reach(column + 1, row), reach(column, row - 1), reach(column, row + 1);
    }
    for (std::size_t cell = 0; cell < open.size(); ++cell) mask.inside[cell] = open[cell] != 0 ? 0 : 1;
    return mask;
}

/// The area of a point that stands inside: twice the mean area of Delaunay triangles. 0 if there are none.
double inner_area(const std::vector<Point>& points, const Mask& mask, const std::vector<double>& depth, double least_depth) {
    double area = 0, count = 0;
    for (const DelaunayTriangle& triangle : delaunay(points)) {
        const auto corner = [&](std::size_t k) { return points[static_cast<std::size_t>(triangle.corners[k])]; };
        const Point a = corner(0), b = corner(1), c = corner(2);
        const std::ptrdiff_t cell = cell_at(mask, (a + b + c) / 3);
        if (cell < 0 || depth[static_cast<std::size_t>(cell)] < least_depth) continue;
        area += 0.5 * cross(b - a, c - a);
        count += 1;
    }
    return count > 0 ? 2 * area / count : 0;
}

/// Where the window begins, so that each point has the area of one inside; half a spacing about the closing if none is.
/// `depth` is of the points widened by `reach`.
double rim_depth(const std::vector<Point>& points, const Mask& mask, std::vector<double> depth, double reach,
                 double spacing) {
    const double each = inner_area(points, mask, depth, reach + triangle_depth * spacing);
    const double cells = each * static_cast<double>(points.size()) / (mask.cell * mask.cell);
    if (cells == 0) return reach - 0.5 * spacing;
    if (cells >= static_cast<double>(depth.size())) return 0;
    const auto last = depth.begin() + static_cast<std::ptrdiff_t>(cells);
    std::nth_element(depth.begin(), last, depth.end(), std::greater<>());
    return *last;
}

PointPattern part(const PointPattern& pattern, int axis, double cut, bool low) {
    const auto on_side = [&](Point p) { return ((axis == 0 ? p.x : p.y) < cut) == low; };
    PointPattern half{{}, {}, pattern.window, {}};
    for (std::size_t i = 0; i < pattern.positions.size(); ++i) {
        if (!on_side(pattern.positions[i])) continue;
        half.positions.push_back(pattern.positions[i]);
        half.symbols.push_back(pattern.symbols[i]);
    }
    for (std::size_t cell = 0; cell < half.window.inside.size(); ++cell)
        if (!on_side(cell_center(half.window, cell))) half.window.inside[cell] = 0;
    return half;
}

}  // namespace

Mask window_about(const std::vector<Point>& points, double spacing) {
    const double reach = closing * spacing;
    Box box;
    for (const Point p : points) box = including(box, p);
    box = grown(box, reach + spacing);
    const double wanted = width(box) * height(box) * (cells_a_spacing / spacing) * (cells_a_spacing / spacing);
    Mask mask = empty_mask(box, static_cast<std::size_t>(std::min(wanted, static_cast<double>(most_cells))));
    for (const Point p : points)
        if (const auto cell = cell_at(mask, p); cell >= 0) mask.inside[static_cast<std::size_t>(cell)] = 1;
    const std::vector<float> away = distances_to_marked({mask.columns, mask.rows, mask.inside}, {mask.cell, mask.cell});
    for (std::size_t cell = 0; cell < away.size(); ++cell)
        mask.inside[cell] = static_cast<double>(away[cell]) <= reach ? 1 : 0;
    mask = without_holes(std::move(mask));
    const std::vector<double> depth = depths(mask);
    const double drop = rim_depth(points, mask, depth, reach, spacing);
    for (std::size_t cell = 0; cell < depth.size(); ++cell) mask.inside[cell] = depth[cell] > drop ? 1 : 0;
    return mask;
}

PointPattern pattern_of(std::vector<Point> positions, std::vector<int> symbols, double spacing) {
    Mask window = window_about(positions, spacing);
    return {std::move(positions), std::move(symbols), std::move(window), {}};
}

PointPattern tiled_pattern(std::vector<Point> positions, std::vector<int> symbols, const Box& tile) {
    for (Point& p : positions) {
        p.x -= width(tile) * std::floor((p.x - tile.low.x) / width(tile));
        p.y -= height(tile) * std::floor((p.y - tile.low.y) / height(tile));
    }
    Mask window = empty_mask(tile, tile_cells);
    std::fill(window.inside.begin(), window.inside.end(), std::uint8_t{1});
    return {std::move(positions), std::move(symbols), std::move(window), tile};
}

double area(const PointPattern& pattern) {
    return pattern.tile ? width(*pattern.tile) * height(*pattern.tile) : area(pattern.window);
}

double density(const PointPattern& pattern) { return static_cast<double>(pattern.positions.size()) / area(pattern); }

std::array<PointPattern, 2> halves(const PointPattern& pattern, int axis) {
    Box box;
    for (std::size_t cell = 0; cell < pattern.window.inside.size(); ++cell)
        if (pattern.window.inside[cell] != 0) box = including(box, cell_center(pattern.window, cell));
    const double cut = axis == 0 ? center(box).x : center(box).y;
    return {part(pattern, axis, cut, true), part(pattern, axis, cut, false)};
}

}  // namespace rinceau
