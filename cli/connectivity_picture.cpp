#include "cli/connectivity_picture.h"

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

std::string connectivity_svg(const std::vector<ConnectivityNode>& nodes, const std::vector<std::pair<int, int>>& edges,
                             const Box& canvas) {
    double total = 0;
    for (const auto& [a, b] : edges)
        total += abs(nodes[static_cast<std::size_t>(a)].position - nodes[static_cast<std::size_t>(b)].position);
    const double edge = edges.empty() ? diagonal(canvas) : total / static_cast<double>(edges.size());
    constexpr double line_share = 0.04, dot_share = 0.07, text_share = 0.3;  // of a mean edge

    std::string svg = opening(canvas) + "<g fill=\"#d9d9d9\" fill-rule=\"evenodd\">\n";
    for (const ConnectivityNode& node : nodes) {
        if (!node.outline.empty()) svg += "<path d=\"" + path_of(node.outline) + "\"/>\n";
    }
    svg += "</g>\n<path fill=\"none\" stroke=\"#1f4e9c\" stroke-linecap=\"round\" stroke-width=\"" +
           number(line_share * edge) + "\" d=\"";
    for (const auto& [a, b] : edges)
        svg += "M" + place(nodes[static_cast<std::size_t>(a)].position) + "L" +
               place(nodes[static_cast<std::size_t>(b)].position);
    svg += "\"/>\n<g font-family=\"sans-serif\" font-size=\"" + number(text_share * edge) + "\">\n";
    for (const ConnectivityNode& node : nodes) {
        const std::string radius = number(dot_share * edge);
        svg += "<circle cx=\"" + number(node.position.x) + "\" cy=\"" + number(-node.position.y) + "\" r=\"" + radius +
               (node.marked ? "\" fill=\"#c0392b\"/>\n" : "\" fill=\"#1f4e9c\"/>\n");
        if (!node.name.empty())
            svg += "<text x=\"" + number(node.position.x + dot_share * edge) + "\" y=\"" +
                   number(-node.position.y - dot_share * edge) + "\">" + node.name + "</text>\n";
    }
    return svg + "</g>\n</svg>\n";
}

std::string numbering_svg(const Exemplar& exemplar, const Box& canvas) {
    std::vector<ConnectivityNode> nodes;
    for (std::size_t i = 0; i < exemplar.elements.size(); ++i) {
        const ExemplarElement& element = exemplar.elements[i];
        ConnectivityNode node{.position = element.position, .outline = element.outline, .marked = !element.usable};
        for (std::vector<Point>& ring : node.outline) {
            for (Point& p : ring) p += element.position;
        }
        if (i < exemplar.originals) node.name = std::to_string(i + 1);
        nodes.push_back(std::move(node));
    }
    return connectivity_svg(nodes, exemplar.edges, canvas);
}

}  // namespace rinceau
