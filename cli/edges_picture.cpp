#include "cli/edges_picture.h"

#include <algorithm>

#include "scene/svg_number.h"

namespace rinceau {
namespace {

constexpr int digits = 6;

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

}  // namespace

std::string edges_svg(const std::vector<PicturedNode>& nodes, const std::vector<std::pair<int, int>>& edges,
                      const Box& canvas) {
    double total = 0;
    for (const auto& [a, b] : edges)
        total += abs(nodes[static_cast<std::size_t>(a)].position - nodes[static_cast<std::size_t>(b)].position);
    const double edge = edges.empty() ? diagonal(canvas) : total / static_cast<double>(edges.size());
    constexpr double line_share = 0.04, dot_share = 0.07;  // of a mean edge

    std::string svg = opening(canvas) + "<g fill=\"#d9d9d9\" fill-rule=\"evenodd\">\n";
    for (const PicturedNode& node : nodes) {
        if (!node.outline.empty()) svg += "<path d=\"" + path_of(node.outline) + "\"/>\n";
    }
    svg += "</g>\n<path fill=\"none\" stroke=\"#1f4e9c\" stroke-linecap=\"round\" stroke-width=\"" +
           number(line_share * edge) + "\" d=\"";
    for (const auto& [a, b] : edges)
        svg += "M" + place(nodes[static_cast<std::size_t>(a)].position) + "L" +
               place(nodes[static_cast<std::size_t>(b)].position);
    svg += "\"/>\n<g fill=\"#1f4e9c\">\n";
    for (const PicturedNode& node : nodes)
        svg += "<circle cx=\"" + number(node.position.x) + "\" cy=\"" + number(-node.position.y) + "\" r=\"" +
               number(dot_share * edge) + "\"/>\n";
    return svg + "</g>\n</svg>\n";
}

}  // namespace rinceau
