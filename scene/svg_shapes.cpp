#include "scene/svg_shapes.h"

#include <algorithm>

#include "geometry/angle.h"
#include "scene/svg_arc.h"
#include "scene/svg_number.h"

namespace rinceau {

namespace {

// A quarter of an axis-parallel ellipse from the path's end, the corner of its tangents given.
Segment quarter(Point from, Point corner, Point to) {
    const double handle = arc_handle(pi / 2);
    return curve_to(from + handle * (corner - from), to + handle * (corner - to), to);
}

// The two radii of a rectangle's corners. (SVG 2, section 10.2)
Point corner_radii(const RectangleShape& shape) {
    const auto given = [](const std::optional<double>& radius) { return radius && *radius >= 0; };
    double rx = given(shape.rx) ? *shape.rx : given(shape.ry) ? *shape.ry : 0;
    double ry = given(shape.ry) ? *shape.ry : rx;
    rx = std::min(rx, shape.width / 2);
    ry = std::min(ry, shape.height / 2);
    return rx > 0 && ry > 0 ? Point{rx, ry} : Point{};
}

}  // namespace

std::vector<Path> rectangle(const RectangleShape& shape) {
    if (!(shape.width > 0 && shape.height > 0)) return {};
    const double left = shape.x, right = shape.x + shape.width, top = shape.y, bottom = shape.y + shape.height;
    const auto [rx, ry] = corner_radii(shape);
    if (rx == 0) return {{{left, top}, {line_to({right, top}), line_to({right, bottom}), line_to({left, bottom})}, true}};
    Path path{{left + rx, top}, {}, true};
    Point at = path.start;
    const auto side = [&](Point to) {
        if (to != at) path.segments.push_back(line_to(to));
        at = to;
    };
    const auto corner = [&](Point tangent, Point to) {
        path.segments.push_back(quarter(at, tangent, to));
        at = to;
    };
    side({right - rx, top});
    corner({right, top}, {right, top + ry});
    side({right, bottom - ry});
    corner({right, bottom}, {right - rx, bottom});
    side({left + rx, bottom});
    corner({left, bottom}, {left, bottom - ry});
    side({left, top + ry});
    corner({left, top}, path.start);
    return {path};
}

std::vector<Path> ellipse(Point center, double rx, double ry) {
    if (!(rx > 0 && ry > 0)) return {};
    const auto at = [&](double x, double y) { return center + Point{x * rx, y * ry}; };
    return {{at(1, 0),
             {quarter(at(1, 0), at(1, 1), at(0, 1)), quarter(at(0, 1), at(-1, 1), at(-1, 0)),
              quarter(at(-1, 0), at(-1, -1), at(0, -1)), quarter(at(0, -1), at(1, -1), at(1, 0))},
             true}};
}

std::vector<Path> line(Point from, Point to) { return {{from, {line_to(to)}, false}}; }

std::vector<Path> polyline(std::span<const Point> points, bool closed) {
    if (points.empty()) return {};
    if (points.size() == 1 && !closed) return line(points[0], points[0]);
    Path path{points[0], {}, closed};
    for (const Point to : points.subspan(1)) path.segments.push_back(line_to(to));
    return {path};
}

ParsedPoints parse_points(std::string_view text) {
    ParsedPoints result;
    TextCursor cursor{trimmed(text)};
    const auto fail = [&](const char* fault) {
        result.faulty = true;
        result.fault_at = static_cast<std::size_t>(cursor.text.data() - text.data()) + cursor.at;
        result.fault = fault;
        return result;
    };
    while (!cursor.at_end()) {
        const std::optional<double> x = read_number(cursor);
        if (!x) return fail("expected a number");
        skip_comma_space(cursor);
        const std::optional<double> y = read_number(cursor);
        if (!y) return fail(cursor.at_end() ? "odd number of coordinates" : "expected a number");
        result.points.push_back({*x, *y});
        if (skip_comma_space(cursor) && cursor.at_end()) return fail("expected a number after the comma");
    }
    return result;
}

}  // namespace rinceau
