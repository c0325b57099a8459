// Fill: rows of the grid are cut by the outline's edges, winding numbers add up from the right. Stroke: distance to the
// edges.

#include "analyzer/painted_samples.h"

#include <limits>

namespace rinceau {
namespace {

constexpr double unbounded = std::numeric_limits<double>::infinity();

/// The first and one past the last index whose coordinate lies in [low, high].
struct IndexRange {
    int begin = 0;
    int end = 0;
};

int clamped_index(double index, int count) { return static_cast<int>(std::clamp(index, 0.0, static_cast<double>(count))); }

IndexRange indices_within(double low, double high, double origin, double step, int count) {
    return {clamped_index(std::ceil((low - origin) / step), count),
            clamped_index(std::floor((high - origin) / step) + 1, count)};
}

Point sample_point(const SampleGrid& grid, int column, int row) {
    return grid.origin + grid.step * Point{double(column), double(row)};
}

Box box_of(const SampleGrid& grid) { return {grid.origin, sample_point(grid, grid.columns - 1, grid.rows - 1)}; }

std::size_t index_of(const SampleGrid& grid, int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) + static_cast<std::size_t>(column);
}

std::size_t sample_count(const SampleGrid& grid) {
    return static_cast<std::size_t>(grid.rows) * static_cast<std::size_t>(grid.columns);
}

/// Counts the edge, in each row that it crosses, at the last sample left of it.
void count_crossings(const ThickEdge& edge, const SampleGrid& grid, std::vector<int>& crossings) {
    const IndexRange rows = indices_within(std::min(edge.from.y, edge.to.y), std::max(edge.from.y, edge.to.y), grid.origin.y,
                                           grid.step, grid.rows);
    for (int row = rows.begin; row < rows.end; ++row) {
        const double y = grid.origin.y + grid.step * row;
        if ((edge.from.y <= y) == (edge.to.y <= y)) continue;
        const double x = edge.from.x + (y - edge.from.y) / (edge.to.y - edge.from.y) * (edge.to.x - edge.from.x);
        const int left_of_edge = clamped_index(std::ceil((x - grid.origin.x) / grid.step), grid.columns);
        if (left_of_edge > 0) crossings[index_of(grid, left_of_edge - 1, row)] += edge.to.y > edge.from.y ? 1 : -1;
    }
}

std::vector<char> filled_samples(const PaintedOutline& outline, const SampleGrid& grid) {
    std::vector<char> filled(sample_count(grid), 0);
    if (!outline.solid) return filled;
    std::vector<int> crossings(filled.size(), 0);
    const Box box = box_of(grid);
    visit_edges(outline, {box.low, {unbounded, box.high.y}}, [&](std::size_t i) {
        if (i < outline.outline_edges) count_crossings(outline.edges[i], grid, crossings);
        return true;
    });
    for (int row = 0; row < grid.rows; ++row) {
        int winding = 0;
        for (int column = grid.columns - 1; column >= 0; --column) {
            winding += crossings[index_of(grid, column, row)];
            filled[index_of(grid, column, row)] = outline.fill_rule == FillRule::nonzero ? winding != 0 : winding % 2 != 0;
        }
    }
    return filled;
}

/// An edge made ready for many points.
struct StrokeEdge {
    Point from;
    Point along;
    double squared_length = 0;
    double squared_radius = 0;
    double tip_slope = 0;

    bool paints(Point p) const {
        const double forward = dot(p - from, along);
        if (tip_slope > 0) return forward >= 0 && std::abs(cross(along, p - from)) <= (squared_length - forward) * tip_slope;
        const double share = squared_length > 0 ? std::clamp(forward / squared_length, 0.0, 1.0) : 0;
        return norm(p - from - share * along) <= squared_radius;
    }
};

std::vector<char> stroked_samples(const PaintedOutline& outline, const SampleGrid& grid) {
    std::vector<char> stroked(sample_count(grid), 0);
    const double least_radius = grid.step / 2;
    visit_edges(outline, grown(box_of(grid), least_radius), [&](std::size_t i) {
        const ThickEdge& edge = outline.edges[i];
        if (edge.radius <= 0 && edge.tip_slope <= 0) return true;
        const double radius = std::max(edge.radius, least_radius);
        const Point along = edge.to - edge.from;
        const StrokeEdge stroke{edge.from, along, norm(along), radius * radius, edge.tip_slope};
        const Box box = grown(including(including(Box{}, edge.from), edge.to),
                              edge.tip_slope > 0 ? edge.tip_slope * abs(edge.to - edge.from) : radius);
        const IndexRange columns = indices_within(box.low.x, box.high.x, grid.origin.x, grid.step, grid.columns);
        const IndexRange rows = indices_within(box.low.y, box.high.y, grid.origin.y, grid.step, grid.rows);
        for (int row = rows.begin; row < rows.end; ++row) {
            for (int column = columns.begin; column < columns.end; ++column) {
                char& sample = stroked[index_of(grid, column, row)];
                if (!sample && stroke.paints(sample_point(grid, column, row))) sample = 1;
            }
        }
        return true;
    });
    return stroked;
}

}  // namespace

PaintedElement painted_element(const Element& element, double deviation) {
    const Style& style = element.style;
    PaintedElement painted{.outline = painted_outline(element, deviation),
                           .strokes = paints_stroke(style),
                           .dashed = !style.stroke.dashes.empty(),
                           .stroke_first = style.stroke_first,
                           .opacity = style.opacity};
    if (paints_fill(style)) painted.fill = paint_sampler(style.fill, style.fill_opacity);
    if (painted.strokes) painted.stroke = paint_sampler(style.stroke.paint, style.stroke.opacity);
    return painted;
}

std::vector<Ink> painted_samples(const PaintedElement& element, const SampleGrid& grid, bool stroked) {
    const std::vector<char> in_fill = filled_samples(element.outline, grid);
    const bool strokes = element.strokes && stroked;
    const std::vector<char> in_stroke =
        strokes ? stroked_samples(element.outline, grid) : std::vector<char>(in_fill.size(), 0);
    const double stroke_share = std::min(1.0, 2 * element.outline.stroke_radius / grid.step);
    std::vector<Ink> inks(in_fill.size());
    for (int row = 0; row < grid.rows; ++row) {
        for (int column = 0; column < grid.columns; ++column) {
            const std::size_t i = index_of(grid, column, row);
            if (!in_fill[i] && !in_stroke[i]) continue;
            const Point p = sample_point(grid, column, row);
            const Ink fill = in_fill[i] ? paint_at(element.fill, p) : Ink{};
            const Ink stroke = in_stroke[i] ? stroke_share * paint_at(element.stroke, p) : Ink{};
            inks[i] = element.opacity * (element.stroke_first ? over(fill, stroke) : over(stroke, fill));
        }
    }
    return inks;
}

std::optional<Ink> uniform_ink(const PaintedElement& element, const Box& box) {
    if (!overlap(element.outline.box, box)) return Ink{};
    if (edges_reach(element.outline, box)) return std::nullopt;
    if (!fills_point(element.outline, center(box))) return Ink{};
    if (element.fill.gradient != nullptr) return std::nullopt;
    return element.opacity * element.fill.solid;
}

}  // namespace rinceau
