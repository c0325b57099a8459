#include "growth/surface/lay_elements.h"

#include <algorithm>
#include <cmath>

#include "growth/surface/relax_chart.h"

namespace rinceau {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The smallest stretched corner of a face may lie this much farther out than the place below it.
constexpr double patch_margin = 1.02;
constexpr double relaxed_margin = 1.4;
constexpr int relaxing_rounds = 12;

/// The terminal's frame -> the chart's plane.
Similarity to_chart(const ElementChart& chart, const Similarity& pose, const ElementLayer::Size& size) {
    const Similarity sized{{size.factor, 0}, size.about - size.factor * size.about, false};
    const Similarity laid{{chart.scale, 0}, -chart.scale * chart.middle.drawn, false};
    return laid * sized * pose;
}

std::vector<std::array<Point, 2>> rim_lines(const ArtLayer& layer, const std::vector<Point>& points, bool mirrored) {
    std::vector<std::array<Point, 2>> lines;
    for (const auto& [i, j] : layer.borders)
        lines.push_back(mirrored ? std::array{points[at(j)], points[at(i)]} : std::array{points[at(i)], points[at(j)]});
    return lines;
}

}  // namespace

DrawnElement drawn_element(const TerminalArt& art, const Similarity& pose) {
    DrawnElement element{art.layers.empty() ? nullptr : &art, pose, {}, {}};
    for (const Point p : art.hull) element.hull.push_back(apply(pose, p));
    if (pose.mirrored) std::ranges::reverse(element.hull);
    for (const Point p : element.hull) element.box = including(element.box, p);
    return element;
}

DrawnDisc disc_of(std::span<const DrawnElement> elements, std::span<const int> chosen) {
    DrawnDisc disc;
    Box box;
    for (const int i : chosen) box = including(box, elements[at(i)].box);
    disc.centre = center(box);
    for (const int i : chosen)
        for (const Point p : elements[at(i)].hull) {
            disc.radius = std::max(disc.radius, abs(p - disc.centre));
            disc.largest = std::max(disc.largest, abs(p - center(elements[at(i)].box)));
        }
    return disc;
}

ElementChart ElementLayer::polar_chart(const DrawingStand& middle, double radius) {
    return {drawing_chart(*surface_, patches_.patch(middle.at, middle.turn, patch_margin * scale_ * radius)), middle,
            scale_};
}

ElementChart ElementLayer::relaxed_polar_chart(const DrawingStand& middle, double radius) {
    std::vector<ChartTriangle> patch = patches_.patch(middle.at, middle.turn, relaxed_margin * scale_ * radius);
    return {drawing_chart(*surface_, relaxed_chart(*surface_, std::move(patch), relaxing_rounds)), middle, scale_};
}

LayFault ElementLayer::lay_one(const ElementChart& chart, const DrawnElement& element, double stretch, const Size& size,
                               LaidShape& shape) {
    const Similarity map = to_chart(chart, element.pose, size);
    shape.pose = map;
    for (const ArtLayer& layer : element.art->layers) {
        std::vector<Point> points;
        points.reserve(layer.points.size());
        for (const Point p : layer.points) points.push_back(apply(map, p));
        std::vector<std::array<int, 3>> turned;
        if (map.mirrored)
            for (const auto& [a, b, c] : layer.triangles) turned.push_back({a, c, b});
        const LayingTriangles triangles{points, map.mirrored ? turned : layer.triangles, norm(map.linear) * layer.area};
        LaidLayer& laid = shape.layers.emplace_back(LaidLayer{layer.color, layer.level, {}, {}});
        const LayFault fault = lay_triangles(*surface_, chart.chart, triangles, {stretch}, visits_, laid.area);
        if (fault != LayFault::none) return fault;
        if (rims_) lay_lines(*surface_, chart.chart, rim_lines(layer, points, map.mirrored), visits_, laid.rim);
        shape.area += triangles.area;
    }
    shape.drawn = element.hull;
    bound_shape(*surface_, shape);
    return LayFault::none;
}

ElementLayer::Result ElementLayer::lay(const ElementChart& chart, std::span<const DrawnElement> elements,
                                       std::span<const int> chosen, double stretch, const Size& size) {
    Result result;
    result.shapes.resize(chosen.size());
    // the outermost first: they are the most likely to fail
    std::vector<std::size_t> order(chosen.size());
    std::vector<double> distance(chosen.size());
    for (std::size_t k = 0; k < chosen.size(); ++k) {
        order[k] = k;
        distance[k] = abs(center(elements[at(chosen[k])].box) - chart.middle.drawn);
    }
    std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) { return distance[a] > distance[b]; });
    for (const std::size_t k : order) {
        result.shapes[k].element = chosen[k];
        result.fault = lay_one(chart, elements[at(chosen[k])], stretch, size, result.shapes[k]);
        if (result.fault != LayFault::none) {
            result.shapes.clear();
            break;
        }
    }
    return result;
}

}  // namespace rinceau
