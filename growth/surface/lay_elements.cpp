#include "growth/surface/lay_elements.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "geometry/index.h"
#include "growth/surface/relax_chart.h"

namespace rinceau {
namespace {

/// The smallest stretched corner of a face may lie this much farther out than the place below it.
constexpr double patch_margin = 1.02;
constexpr double relaxed_margin = 1.4;
constexpr int relaxing_rounds = 12;
/// A strip's patch is so much wider than the strip: sideways, polar places are off by their stretch.
constexpr double strip_margin = 3;
/// What the polar map has torn.
constexpr double unusable_stretch = 8;
constexpr double torn_edges = 3;  // length of a torn face's longest edge in the chart, by its own
/// So much of the radius a drawing's sheet reaches out of its box.
constexpr double sheet_margin = 0.3;

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

/// The triangles that hang together, by edges, with the one of `face`.
std::vector<ChartTriangle> part_with(const SurfaceMesh& surface, const std::vector<ChartTriangle>& patch, int face) {
    std::map<int, std::size_t> index;
    for (std::size_t t = 0; t < patch.size(); ++t) index[patch[t].face] = t;
    std::vector<bool> taken(patch.size(), false);
    std::vector<int> open{face};
    taken[index.at(face)] = true;
    while (!open.empty()) {
        const int from = open.back();
        open.pop_back();
        for (int h = 3 * from; h < 3 * from + 3; ++h) {
            const int twin = surface.twin[at(h)];
            if (twin < 0) continue;
            const auto found = index.find(face_of(twin));
            if (found == index.end() || taken[found->second]) continue;
            taken[found->second] = true;
            open.push_back(face_of(twin));
        }
    }
    std::vector<ChartTriangle> part;
    for (std::size_t t = 0; t < patch.size(); ++t)
        if (taken[t]) part.push_back(patch[t]);
    return part;
}

/// Does it reach over the line behind the body where polar coordinates come together?
bool is_torn(const SurfaceMesh& surface, const ChartTriangle& triangle) {
    const auto& flat = surface.flat[at(triangle.face)];
    double drawn = 0, own = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        drawn = std::max(drawn, abs(triangle.at[(k + 1) % 3] - triangle.at[k]));
        own = std::max(own, abs(flat[(k + 1) % 3] - flat[k]));
    }
    return drawn > torn_edges * own;
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

DrawnStrip strip_of(const DrawnElement& element) {
    DrawnStrip strip;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < element.hull.size(); ++k) {
        const Point side = element.hull[(k + 1) % element.hull.size()] - element.hull[k];
        if (!(abs(side) > 0)) continue;
        const Complex along = side / abs(side);
        Box box;
        for (const Point p : element.hull) box = including(box, conj(along) * p);
        if (height(box) >= least) continue;
        least = height(box);
        strip = {along * center(box), along, 0.5 * width(box), 0.5 * height(box)};
    }
    if (strip.half_length < strip.half_width) {
        std::swap(strip.half_length, strip.half_width);
        strip.along = strip.along * Complex{0, 1};
    }
    return strip;
}

ElementChart ElementLayer::polar_chart(const DrawingStand& middle, double radius) {
    return {drawing_chart(*surface_, patches_.patch(middle.at, middle.turn, patch_margin * scale_ * radius)), middle,
            scale_};
}

ElementChart ElementLayer::relaxed_polar_chart(const DrawingStand& middle, double radius) {
    std::vector<ChartTriangle> patch = patches_.patch(middle.at, middle.turn, relaxed_margin * scale_ * radius);
    return {drawing_chart(*surface_, relaxed_chart(*surface_, std::move(patch), relaxing_rounds)), middle, scale_};
}

ElementChart ElementLayer::sheet_chart(const DrawingStand& middle, double radius, const Box& drawn) {
    std::vector<ChartTriangle> patch = patches_.patch(middle.at, middle.turn, relaxed_margin * scale_ * radius);
    const Box reach =
        grown({scale_ * (drawn.low - middle.drawn), scale_ * (drawn.high - middle.drawn)}, sheet_margin * scale_ * radius);
    std::erase_if(patch, [&](const ChartTriangle& triangle) {
        Box box;
        for (const Complex p : triangle.at) box = including(box, p);
        return triangle.face != middle.at.face && (!overlap(box, reach) || is_torn(*surface_, triangle));
    });
    if (!patch.empty()) patch = part_with(*surface_, patch, middle.at.face);
    return {drawing_chart(*surface_, relaxed_chart(*surface_, std::move(patch), relaxing_rounds)), middle, scale_};
}

ElementChart ElementLayer::bent(const ElementChart& chart, const FieldOnSurface& field, double follow) const {
    return {drawing_chart(*surface_, bent_chart(field, follow, chart.chart.triangles)), chart.middle, chart.scale};
}

ElementChart ElementLayer::strip_chart(const DrawingStand& middle, double radius, const DrawnStrip& strip) {
    std::vector<ChartTriangle> patch = patches_.patch(middle.at, middle.turn, patch_margin * scale_ * radius);
    const double reach = scale_ * strip.half_width * strip_margin;
    const auto beside = [&](const ChartTriangle& triangle) {
        double low = dot(conj(strip.along) * triangle.at[0], {0, 1}), high = low;
        for (const Complex p : triangle.at) {
            const double v = dot(conj(strip.along) * p, {0, 1});
            low = std::min(low, v);
            high = std::max(high, v);
        }
        return low > reach || high < -reach;
    };
    std::erase_if(patch, [&](const ChartTriangle& triangle) {
        return triangle.face != middle.at.face &&
               (beside(triangle) || chart_stretch(*surface_, triangle) > unusable_stretch);
    });
    patch = part_with(*surface_, patch, middle.at.face);
    return {drawing_chart(*surface_, relaxed_chart(*surface_, std::move(patch), relaxing_rounds)), middle, scale_};
}

LayFault ElementLayer::lay_one(const ElementChart& chart, const DrawnElement& element, double stretch, const Size& size,
                               LaidShape& shape) {
    const Similarity map = to_chart(chart, element.pose, size);
    shape.pose = map;
    shape.middle = chart.middle.at;
    shape.turn = chart.middle.turn;
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
