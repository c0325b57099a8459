#include "analyzer/painted_outline.h"

#include <cmath>
#include <limits>

#include "geometry/polygon.h"

namespace rinceau {
namespace {

/// A mitre that reaches no further than this many half widths stays inside what its two edges paint, nearly.
constexpr double plain_corner = 1.05;

/// How far to the sides it paints.
double breadth(const ThickEdge& edge) {
    return edge.tip_slope > 0 ? edge.tip_slope * abs(edge.to - edge.from) : edge.radius;
}

Box box_of(const ThickEdge& edge) { return grown(including(including(Box{}, edge.from), edge.to), breadth(edge)); }

/// Largest stretch of a circle by the pen.
double largest_stretch(const Linear2& m) {
    const double sum = std::hypot(m.a + m.d, m.b - m.c);
    const double difference = std::hypot(m.a - m.d, m.b + m.c);
    return (sum + difference) / 2;
}

Point unit(Point v) { return abs(v) > 0 ? v / abs(v) : Point{}; }

/// From a corner to the tip of its mitre, if the mitre is painted and reaches beyond the two edges.
void append_mitre(std::vector<ThickEdge>& edges, Point before, Point at, Point after, double radius, double limit) {
    const Point outward = unit(at - before) - unit(after - at);
    const double half_sine = abs(unit(at - before) + unit(after - at)) / 2;  // sine of half the inner angle
    if (half_sine <= 0 || abs(outward) <= 0) return;
    const double reach = 1 / half_sine;
    if (reach <= plain_corner || reach > limit) return;
    const double slope = 1 / std::sqrt(reach * reach - 1);
    edges.push_back({at, at + radius * reach * unit(outward), 0, slope});
}

void append_stroke_tips(std::vector<ThickEdge>& edges, const std::vector<Point>& line, bool closed, const Stroke& stroke,
                        double radius) {
    const std::size_t n = line.size();
    if (stroke.join == LineJoin::miter && n > 2) {
        for (std::size_t i = closed ? 0 : 1; i < (closed ? n : n - 1); ++i) {
            append_mitre(edges, line[(i + n - 1) % n], line[i], line[(i + 1) % n], radius, stroke.miter_limit);
        }
    }
    if (stroke.cap == LineCap::square && !closed) {
        const auto append_cap = [&](Point end, Point inner) {
            const Point along = end == inner ? Point{1, 0} : unit(end - inner);
            edges.push_back({end, end + radius * along, radius});
        };
        append_cap(line.front(), line[n > 1 ? 1 : 0]);
        append_cap(line.back(), line[n > 1 ? n - 2 : 0]);
    }
}

/// The polyline's edges; a single point is an edge of length 0.
void append_outline(PaintedOutline& region, const std::vector<Point>& line, bool closed, double radius) {
    for (std::size_t i = 0; i + 1 < line.size(); ++i) region.edges.push_back({line[i], line[i + 1], radius});
    if (line.size() == 1 || closed)
        region.edges.push_back({line.back(), line.front(), radius});
    else if (region.solid)
        region.edges.push_back({line.back(), line.front(), 0});
}

bool edges_touch(const ThickEdge& a, const ThickEdge& b, double margin) {
    const double reach = a.radius + b.radius + margin;
    return distance_to_segment(a.from, b.from, b.to) <= reach || distance_to_segment(a.to, b.from, b.to) <= reach ||
           distance_to_segment(b.from, a.from, a.to) <= reach || distance_to_segment(b.to, a.from, a.to) <= reach ||
           segment_crossing(a.from, a.to, b.from, b.to).has_value();
}

/// Separated by the axes or by the edge's own direction, or not.
bool edge_reaches(const ThickEdge& edge, const Box& box) {
    if (!overlap(box_of(edge), box)) return false;
    const Point along = edge.to - edge.from;
    const double side = cross(along, center(box) - edge.from);
    const double half = (std::abs(along.y) * width(box) + std::abs(along.x) * height(box)) / 2;
    return std::abs(side) <= half + breadth(edge) * abs(along);
}

bool touches_any_edge(const PaintedOutline& region, const ThickEdge& probe, double margin) {
    const Box reach = grown(box_of(probe), margin);
    bool touching = false;
    const auto try_edge = [&](std::size_t i) { return !(touching = edges_touch(region.edges[i], probe, margin)); };
    if (region.edges.size() > edges_without_tree) {
        region.tree.visit(reach, try_edge);
    } else {
        for (std::size_t i = 0; i < region.edges.size() && !touching; ++i) {
            if (overlap(box_of(region.edges[i]), reach)) try_edge(i);
        }
    }
    return touching;
}

bool any_start_inside(const PaintedOutline& inner, const PaintedOutline& outer) {
    for (const Point p : inner.starts) {
        if (fills_point(outer, p)) return true;
    }
    return false;
}

}  // namespace

bool fills_point(const PaintedOutline& region, Point p) {
    if (!region.solid || !overlap(region.box, {p, p})) return false;
    int winding = 0;
    visit_edges(region, {p, {std::numeric_limits<double>::infinity(), p.y}}, [&](std::size_t i) {
        if (i >= region.outline_edges) return true;
        const ThickEdge& edge = region.edges[i];
        const bool up = edge.from.y <= p.y && edge.to.y > p.y;
        const bool down = edge.to.y <= p.y && edge.from.y > p.y;
        const double side = cross(edge.to - edge.from, p - edge.from);
        if ((up && side > 0) || (down && side < 0)) winding += up ? 1 : -1;
        return true;
    });
    return region.fill_rule == FillRule::nonzero ? winding != 0 : winding % 2 != 0;
}

bool edges_reach(const PaintedOutline& region, const Box& box) {
    bool reached = false;
    visit_edges(region, box, [&](std::size_t i) { return !(reached = edge_reaches(region.edges[i], box)); });
    return reached;
}

PaintedOutline painted_outline(const Element& element, double deviation) {
    const Stroke& stroke = element.style.stroke;
    const bool stroked = paints_stroke(element.style);
    const double radius = stroked ? stroke.width / 2 * largest_stretch(stroke.pen) : 0;
    PaintedOutline region{.box = painted_box(element),
                          .solid = paints_fill(element.style),
                          .fill_rule = element.style.fill_rule,
                          .stroke_radius = radius};
    std::vector<ThickEdge> tips;
    for (const Path& path : element.paths) {
        const std::vector<Point> line = flattened(path, deviation);
        if (line.empty()) continue;
        region.starts.push_back(line.front());
        append_outline(region, line, path.closed, radius);
        if (stroked) append_stroke_tips(tips, line, path.closed, stroke, radius);
    }
    region.outline_edges = region.edges.size();
    region.edges.insert(region.edges.end(), tips.begin(), tips.end());
    if (region.edges.size() > edges_without_tree) {
        std::vector<Box> boxes;
        for (const ThickEdge& edge : region.edges) boxes.push_back(box_of(edge));
        region.tree = BoxTree(boxes);
    }
    return region;
}

bool paint_touches(const PaintedOutline& a, const PaintedOutline& b, double margin) {
    // The common case of a thing on a ground is decided by one point.
    if (any_start_inside(a, b) || any_start_inside(b, a)) return true;
    const PaintedOutline& fewer = a.edges.size() <= b.edges.size() ? a : b;
    const PaintedOutline& more = a.edges.size() <= b.edges.size() ? b : a;
    const Box reach = grown(more.box, margin);
    for (const ThickEdge& probe : fewer.edges) {
        if (overlap(box_of(probe), reach) && touches_any_edge(more, probe, margin)) return true;
    }
    return false;
}

}  // namespace rinceau
