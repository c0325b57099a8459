#include "closed_loop/shapes.h"

#include <utility>

namespace rinceau::test {

Path polygon(const std::vector<Point>& corners) {
    Path path{.start = corners.front(), .closed = true};
    for (std::size_t i = 1; i < corners.size(); ++i) path.segments.push_back(line_to(corners[i]));
    return path;
}

std::vector<Path> regular_polygon(int corners, double radius) {
    std::vector<Point> points;
    for (int i = 0; i < corners; ++i) points.push_back(polar(radius, pi / 2 + two_pi * i / corners));
    return {polygon(points)};
}

std::vector<Path> circle(double radius) {
    const double handle = radius * 4 / 3 * std::tan(pi / 8);
    Path path{.start = {radius, 0}, .closed = true};
    for (int i = 0; i < 4; ++i) {
        const Point from = polar(radius, i * pi / 2);
        const Point to = i == 3 ? path.start : polar(radius, (i + 1) * pi / 2);
        path.segments.push_back(curve_to(from + handle / radius * (Point{0, 1} * from), to - handle / radius * (Point{0, 1} * to), to));
    }
    return {path};
}

std::vector<Path> rectangle(double width, double height) {
    const double x = width / 2;
    const double y = height / 2;
    return {polygon({{-x, -y}, {x, -y}, {x, y}, {-x, y}})};
}

std::vector<Path> star(int points, double inner_radius) {
    std::vector<Point> corners;
    for (int i = 0; i < 2 * points; ++i) corners.push_back(polar(i % 2 == 0 ? 1 : inner_radius, pi / 2 + pi * i / points));
    return {polygon(corners)};
}

std::vector<Path> leaf(double half_width) {
    const double w = half_width * 4 / 3;  // a cubic bulges to 3/4 of its handles
    Path path{.start = {0, -1}, .closed = true};
    path.segments = {curve_to({w, -0.5}, {w, 0.4}, {0, 1}), curve_to({-w, 0.4}, {-w, -0.5}, {0, -1})};
    return {path};
}

std::vector<Path> hook() {
    return {polygon({{-0.3, -0.9}, {0.1, -0.9}, {0.1, 0.4}, {0.7, 0.4}, {0.7, 0.7}, {-0.3, 0.6}})};
}

std::vector<Path> blob(int nodes, Random& random) {
    std::vector<Point> points;
    for (int i = 0; i < nodes; ++i) points.push_back(polar(random.uniform(0.55, 1.0), two_pi * (i + random.uniform(0, 0.4)) / nodes));
    // Catmull and Rom 1974: tangents along the chords of the neighbours.
    const auto at = [&](int i) { return points[static_cast<std::size_t>((i + nodes) % nodes)]; };
    Path path{.start = points.front(), .closed = true};
    for (int i = 0; i < nodes; ++i) {
        path.segments.push_back(curve_to(at(i) + (at(i + 1) - at(i - 1)) / 6, at(i + 1) - (at(i + 2) - at(i)) / 6, at(i + 1)));
    }
    return {path};
}

std::vector<Path> bar() { return {Path{.start = {0, -1}, .segments = {line_to({0, 1})}}}; }

std::vector<Path> frame(int corners, double hole) {
    std::vector<Path> outer = regular_polygon(corners);
    std::vector<Path> inner = transformed(regular_polygon(corners, hole), mirror_about_heading());  // winds the other way
    outer.push_back(std::move(inner.front()));
    return outer;
}

Style filled(Color color) { return {.fill = color}; }

Style stroked(Color color, double width) {
    Style style{.fill = NoPaint{}};
    style.stroke.paint = color;
    style.stroke.width = width;
    return style;
}

Element element(std::vector<Path> paths, Style style) { return {.paths = std::move(paths), .style = std::move(style)}; }

Element placed(const Element& element, const Similarity& map) {
    Element copy = element;
    copy.paths = transformed(element.paths, map);
    copy.style = transformed(element.style, map);
    return copy;
}

Color random_color(Random& random) {
    const auto channel = [&] { return static_cast<std::uint8_t>(random.below(256)); };
    const std::uint8_t red = channel();
    const std::uint8_t green = channel();
    return {red, green, channel()};
}

}  // namespace rinceau::test
