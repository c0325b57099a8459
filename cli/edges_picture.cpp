#include "cli/edges_picture.h"

#include <set>

#include "geometry/affine.h"
#include "scene/svg_number.h"

namespace rinceau {
namespace {

constexpr int digits = 5;

std::string number(double value) { return svg_number(value, digits); }
/// SVG's y runs down.
std::string place(Point p) { return number(p.x) + " " + number(-p.y); }

std::string path_of(const Region& outline) {
    std::string path;
    for (const std::vector<Point>& ring : outline) {
        for (std::size_t i = 0; i < ring.size(); ++i) path += (i == 0 ? "M" : "L") + place(ring[i]);
        path += "Z";
    }
    return path;
}

std::string opening(const Box& canvas) {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + number(width(canvas)) + "\" height=\"" +
           number(height(canvas)) + "\" viewBox=\"" + place({canvas.low.x, canvas.high.y}) + " " + number(width(canvas)) +
           " " + number(height(canvas)) + "\">\n";
}

/// A map of y-up space as SVG writes it, y down.
std::string matrix_of(const Similarity& pose) {
    const Affine map = to_affine(pose);
    return "matrix(" + number(map.a) + " " + number(-map.b) + " " + number(-map.c) + " " + number(map.d) + " " +
           number(map.e) + " " + number(-map.f) + ")";
}

std::string figures_svg(const FiguredDrawing& drawing, const std::vector<PlacedFigure>& placed) {
    std::set<int> used;
    for (const PlacedFigure& one : placed) used.insert(one.figure);
    std::string svg = "<defs>\n";
    for (const int figure : used)
        svg += "<path id=\"f" + std::to_string(figure) + "\" d=\"" +
               path_of(drawing.figures[static_cast<std::size_t>(figure)].outline) + "\"/>\n";
    svg += "</defs>\n<g fill=\"#d9d9d9\" fill-rule=\"evenodd\">\n";
    for (const PlacedFigure& one : placed)
        svg += "<use href=\"#f" + std::to_string(one.figure) + "\" transform=\"" + matrix_of(one.pose) + "\"/>\n";
    return svg + "</g>\n";
}

}  // namespace

std::string edges_svg(const FiguredDrawing& drawing, const std::vector<PlacedFigure>& placed,
                      const std::vector<std::pair<int, int>>& edges, const Box& canvas) {
    const auto position = [&placed](int index) { return placed[static_cast<std::size_t>(index)].pose.translation; };
    double total = 0;
    for (const auto& [a, b] : edges) total += abs(position(a) - position(b));
    const double edge = edges.empty() ? diagonal(canvas) : total / static_cast<double>(edges.size());
    constexpr double line_share = 0.04, dot_share = 0.14;  // of a mean edge

    std::string lines, dots;
    for (const auto& [a, b] : edges) lines += "M" + place(position(a)) + "L" + place(position(b));
    for (const PlacedFigure& one : placed) dots += "M" + place(one.pose.translation) + "h0";
    const auto drawn = [](const std::string& path, double stroke_width) {
        return "<path stroke-width=\"" + number(stroke_width) + "\" d=\"" + path + "\"/>\n";
    };
    return opening(canvas) + figures_svg(drawing, placed) +
           "<g fill=\"none\" stroke=\"#1f4e9c\" stroke-linecap=\"round\">\n" + drawn(lines, line_share * edge) +
           drawn(dots, dot_share * edge) + "</g>\n</svg>\n";
}

}  // namespace rinceau
