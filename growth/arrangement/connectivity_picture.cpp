#include "growth/arrangement/connectivity_picture.h"

#include <array>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

#include "geometry/angle.h"

namespace rinceau {
namespace {

/// Corners of a digit as on a pocket calculator, in a cell of 1 x 2: letters a to f, row by row from the bottom left.
constexpr std::array<std::string_view, 10> digit_strokes{"abfea",  "fb",      "efdcab", "efbadc",  "ecd fb",
                                                         "fecdba", "fecabdc", "efb",    "aefbacd", "bfecd"};

Point digit_corner(char corner) {
    const int place = corner - 'a';
    return {static_cast<double>(place % 2), static_cast<double>(place / 2)};
}

std::vector<Path> number_paths(int number, Point at, double height) {
    constexpr double advance = 1.6;  // of a digit's width
    std::vector<Path> paths;
    double across = 0;
    for (const char digit : std::to_string(number)) {
        bool pen_down = false;
        for (const char corner : digit_strokes[static_cast<std::size_t>(digit - '0')]) {
            if (corner == ' ') {
                pen_down = false;
                continue;
            }
            const Point p = at + 0.5 * height * (digit_corner(corner) + Point{across, 0});
            if (pen_down)
                paths.back().segments.push_back(line_to(p));
            else
                paths.push_back({.start = p});
            pen_down = true;
        }
        across += advance;
    }
    return paths;
}

Path circle_path(Point center, double radius) {
    constexpr double k = 0.5522847498307936;  // of a quarter circle by a cubic
    const Point x{radius, 0};
    const Point y{0, radius};
    Path path{.start = center + x, .closed = true};
    path.segments = {curve_to(center + x + k * y, center + y + k * x, center + y),
                     curve_to(center + y - k * x, center - x + k * y, center - x),
                     curve_to(center - x - k * y, center - y - k * x, center - y),
                     curve_to(center - y + k * x, center + x - k * y, center + x)};
    return path;
}

Path polygon_path(const std::vector<Point>& polygon, Point by) {
    Path path{.start = polygon.front() + by, .closed = true};
    for (std::size_t k = 1; k < polygon.size(); ++k) path.segments.push_back(line_to(polygon[k] + by));
    return path;
}

Style line_style(Color color, double width) {
    Style style;
    style.fill = NoPaint{};
    style.stroke.paint = color;
    style.stroke.width = width;
    style.stroke.join = LineJoin::round;
    style.stroke.cap = LineCap::round;
    return style;
}

Style fill_style(Color color) {
    Style style;
    style.fill = color;
    style.fill_rule = FillRule::evenodd;
    return style;
}

Color kind_color(int kind) {
    constexpr std::array<Color, 6> colors{
        {{200, 30, 30}, {20, 90, 200}, {20, 140, 60}, {200, 110, 0}, {130, 40, 160}, {0, 140, 150}}};
    return colors[static_cast<std::size_t>(kind) % colors.size()];
}

constexpr Color outline_color{205, 205, 205};
constexpr Color edge_color{60, 60, 60};
constexpr Color frame_color{150, 150, 220};

void add_outlines(const Exemplar& exemplar, Scene& scene) {
    for (std::size_t i = 0; i < exemplar.originals; ++i) {
        const ExemplarElement& element = exemplar.elements[i];
        std::vector<Path> paths;
        for (const auto& polygon : element.outline)
            if (!polygon.empty()) paths.push_back(polygon_path(polygon, element.position));
        if (!paths.empty()) scene.elements.push_back({.paths = std::move(paths), .style = fill_style(outline_color)});
    }
}

void add_edge_lines(const Exemplar& exemplar, double width, Scene& scene) {
    std::vector<Path> paths;
    for (const auto& [a, b] : exemplar.edges) {
        if (static_cast<std::size_t>(a) >= exemplar.originals) continue;
        const Point from = exemplar.elements[static_cast<std::size_t>(a)].position;
        paths.push_back({.start = from, .segments = {line_to(exemplar.elements[static_cast<std::size_t>(b)].position)}});
    }
    if (!paths.empty()) scene.elements.push_back({.paths = std::move(paths), .style = line_style(edge_color, width)});
}

void add_marks(const Exemplar& exemplar, double radius, Scene& scene) {
    constexpr double line = 0.35;  // of the radius
    constexpr double digits = 2.4;
    for (std::size_t i = 0; i < exemplar.originals; ++i) {
        const ExemplarElement& element = exemplar.elements[i];
        const Color color = kind_color(element.symbol);
        const Style style = element.usable ? fill_style(color) : line_style(color, line * radius);
        scene.elements.push_back({.paths = {circle_path(element.position, radius)}, .style = style});
        const Point beside = element.position + Point{1.4 * radius, 0.6 * radius};
        scene.elements.push_back({.paths = number_paths(static_cast<int>(i), beside, digits * radius),
                                  .style = line_style(color, 0.7 * line * radius)});
    }
}

}  // namespace

Scene connectivity_picture(const Exemplar& exemplar) {
    constexpr double mark = 0.06;  // of a mean edge
    const double radius = mark * exemplar.mean_edge;
    Scene scene;
    add_outlines(exemplar, scene);
    if (exemplar.tile) {
        const Box& t = *exemplar.tile;
        const Path frame = polygon_path({t.low, {t.high.x, t.low.y}, t.high, {t.low.x, t.high.y}}, {});
        scene.elements.push_back({.paths = {frame}, .style = line_style(frame_color, 0.5 * radius)});
    }
    add_edge_lines(exemplar, 0.3 * radius, scene);
    add_marks(exemplar, radius, scene);
    Box box;
    for (const Element& element : scene.elements) box = including(box, painted_box(element));
    scene.viewport = grown(box, radius);
    return scene;
}

}  // namespace rinceau
