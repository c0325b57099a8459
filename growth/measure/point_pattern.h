#pragma once
// Points of several kinds and the part of the plane that they were looked for in.

#include <array>
#include <optional>
#include <vector>

#include "growth/measure/mask.h"

namespace rinceau {

struct PointPattern {
    std::vector<Point> positions;
    std::vector<int> symbols;
    Mask window;              ///< of a tiled pattern all cells of the tile
    std::optional<Box> tile;  ///< the pattern repeats with its width and height, and positions lie in it
};

/// What the points cover: the area that circles of 1.5 spacings cannot enter from outside without touching a point, with all
/// that it encloses, widened evenly until each point has as much of it as one that stands inside. At least one point.
Mask window_about(const std::vector<Point>& points, double spacing);

/// The window that the points cover.
PointPattern pattern_of(std::vector<Point> positions, std::vector<int> symbols, double spacing);

/// The pattern that a tile repeats; points may lie beside the tile.
PointPattern tiled_pattern(std::vector<Point> positions, std::vector<int> symbols, const Box& tile);

double area(const PointPattern& pattern);
/// Points for each unit of area.
double density(const PointPattern& pattern);

/// The pattern cut in the middle of the window, across x (axis 0) or y (axis 1). Neither half is tiled.
std::array<PointPattern, 2> halves(const PointPattern& pattern, int axis);

}  // namespace rinceau
