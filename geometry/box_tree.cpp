#include "geometry/box_tree.h"

#include <cmath>
#include <numeric>

namespace rinceau {
namespace {

/// The order of the tiles: slices by x, each sorted by y; ties by index.
std::vector<std::size_t> tiled_order(std::span<const Box> boxes, std::size_t per_tile) {
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        if (!is_empty(boxes[i])) order.push_back(i);
    }
    const auto by = [&](auto coordinate) {
        return [&boxes, coordinate](std::size_t i, std::size_t j) {
            const double a = coordinate(center(boxes[i]));
            const double b = coordinate(center(boxes[j]));
            return a != b ? a < b : i < j;
        };
    };
    std::sort(order.begin(), order.end(), by([](Point p) { return p.x; }));
    const double tiles = std::ceil(static_cast<double>(order.size()) / static_cast<double>(per_tile));
    const std::size_t slice = per_tile * static_cast<std::size_t>(std::ceil(std::sqrt(tiles)));
    for (std::size_t first = 0; first < order.size(); first += slice) {
        const std::size_t end = std::min(first + slice, order.size());
        std::sort(order.begin() + static_cast<std::ptrdiff_t>(first), order.begin() + static_cast<std::ptrdiff_t>(end),
                  by([](Point p) { return p.y; }));
    }
    return order;
}

}  // namespace

BoxTree::BoxTree(std::span<const Box> boxes) : indices_(tiled_order(boxes, fan_out)) {
    if (indices_.empty()) return;
    std::vector<Box> level;
    level.reserve(indices_.size());
    for (const std::size_t i : indices_) level.push_back(boxes[i]);
    while (level.size() > fan_out) {
        std::vector<Box> above((level.size() + fan_out - 1) / fan_out);
        for (std::size_t i = 0; i < level.size(); ++i) above[i / fan_out] = including(above[i / fan_out], level[i]);
        levels_.push_back(std::move(level));
        level = std::move(above);
    }
    levels_.push_back(std::move(level));
}

}  // namespace rinceau
