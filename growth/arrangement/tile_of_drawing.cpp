#include "growth/arrangement/tile_of_drawing.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/kd_tree.h"

namespace rinceau {
namespace {

double radius_of(const FiguredDrawing& drawing, const FigureInstance& instance) {
    return drawing.figures[static_cast<std::size_t>(instance.figure)].radius * scale_of(instance.pose);
}

Box box_of(const FiguredDrawing& drawing, const FigureInstance& instance) {
    Box box;
    for (const auto& polygon : drawing.figures[static_cast<std::size_t>(instance.figure)].outline)
        for (const Point p : polygon) box = including(box, apply(instance.pose, p));
    return box;
}

/// Elements of about the same size at the same place.
class TwinSearch {
  public:
    explicit TwinSearch(const FiguredDrawing& drawing) : drawing_(drawing), tree_(middles(drawing)) {}

    /// The instance that looks like `instance` moved by `by`; -1 = none.
    int twin(const FigureInstance& instance, Point by) const {
        constexpr double near = 0.15;  // of the radius
        constexpr double alike = 1.15;
        const double radius = radius_of(drawing_, instance);
        for (const Neighbor& other : tree_.within(instance.pose.translation + by, near * radius)) {
            const double size = radius_of(drawing_, drawing_.instances[other.index]);
            if (size < alike * radius && radius < alike * size) return static_cast<int>(other.index);
        }
        return -1;
    }

  private:
    static std::vector<Point> middles(const FiguredDrawing& drawing) {
        std::vector<Point> points;
        for (const FigureInstance& instance : drawing.instances) points.push_back(instance.pose.translation);
        return points;
    }

    const FiguredDrawing& drawing_;
    KdTree tree_;
};

/// Moves by a tile that bring what leaves the tile back to the opposite edge.
std::vector<Point> moves_back(const Box& box, const Box& tile) {
    constexpr double hair = 0.02;  // of the element
    const double slack = hair * diagonal(box);
    std::vector<Point> moves;
    if (box.low.x < tile.low.x - slack) moves.push_back({width(tile), 0});
    if (box.high.x > tile.high.x + slack) moves.push_back({-width(tile), 0});
    if (box.low.y < tile.low.y - slack) moves.push_back({0, height(tile)});
    if (box.high.y > tile.high.y + slack) moves.push_back({0, -height(tile)});
    return moves;
}

double into(double value, double low, double size) { return value - size * std::floor((value - low) / size); }

}  // namespace

std::optional<Box> evident_tile(const FiguredDrawing& drawing) {
    const Box& tile = drawing.grammar.canvas;
    if (!(width(tile) > 0 && height(tile) > 0) || drawing.instances.empty()) return {};
    const TwinSearch search(drawing);
    std::size_t crossings = 0;
    std::size_t met = 0;
    for (const FigureInstance& instance : drawing.instances)
        for (const Point move : moves_back(box_of(drawing, instance), tile)) {
            ++crossings;
            met += search.twin(instance, move) >= 0 ? 1 : 0;
        }
    constexpr std::size_t fewest = 4;  // two elements, each cut at two edges
    constexpr double nearly_all = 0.8;
    if (crossings < fewest || static_cast<double>(met) < nearly_all * static_cast<double>(crossings)) return {};
    return tile;
}

FiguredDrawing as_tile(FiguredDrawing drawing, const Box& tile) {
    const TwinSearch search(drawing);
    const auto middle_inside = [&](const FigureInstance& instance) {
        const Point p = instance.pose.translation;
        return p.x >= tile.low.x && p.x < tile.high.x && p.y >= tile.low.y && p.y < tile.high.y;
    };
    // each at the place it has in the tile; of those that come to the same place the first that stood there stays
    std::vector<bool> dropped(drawing.instances.size());
    for (std::size_t i = 0; i < drawing.instances.size(); ++i)
        for (int column = -1; column <= 1 && !dropped[i]; ++column)
            for (int row = -1; row <= 1 && !dropped[i]; ++row) {
                if (column == 0 && row == 0) continue;
                const int twin = search.twin(drawing.instances[i], {column * width(tile), row * height(tile)});
                if (twin < 0 || dropped[static_cast<std::size_t>(twin)]) continue;
                const bool here = middle_inside(drawing.instances[i]);
                const bool there = middle_inside(drawing.instances[static_cast<std::size_t>(twin)]);
                dropped[i] = !here || (there && static_cast<std::size_t>(twin) < i);
            }
    FiguredDrawing result = drawing;
    result.instances.clear();
    for (std::size_t i = 0; i < drawing.instances.size(); ++i) {
        if (dropped[i]) continue;
        FigureInstance instance = drawing.instances[i];
        Point& at = instance.pose.translation;
        at = {into(at.x, tile.low.x, width(tile)), into(at.y, tile.low.y, height(tile))};
        const Figure& figure = drawing.figures[static_cast<std::size_t>(instance.figure)];
        const auto is_kept = [&](const Placement& part) {
            return !drawing.grammar.terminals[static_cast<std::size_t>(part.terminal)].verbatim.empty();
        };
        instance.whole = std::ranges::none_of(figure.parts, is_kept);
        result.instances.push_back(instance);
    }
    return result;
}

}  // namespace rinceau
