#include "growth/surface/pattern_svg.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "scene/element.h"
#include "scene/svg_number.h"
#include "scene/svg_write.h"

namespace rinceau {

namespace {

constexpr int digits = 6;  // of coordinates in pixels: finer than any screen

/// Closed paths of a ring of points each.
Path closed_path(const std::vector<Point>& ring) {
    Path path{ring.front(), {}, true};
    for (std::size_t i = 1; i < ring.size(); ++i) path.segments.push_back(line_to(ring[i]));
    return path;
}

std::string outline_data(const Region& outline) {
    std::vector<Path> paths;
    for (const std::vector<Point>& ring : outline)
        if (ring.size() > 2) paths.push_back(closed_path(ring));
    return svg_path_data(paths, digits);
}

/// The parts of a line of one width.
struct Stretch {
    std::size_t first = 0, last = 0;  ///< points
    double width = 0;
};

std::vector<Stretch> stretches_of(const PatternLine& line) {
    constexpr double same = 0.02;  // share by which widths may differ and still be drawn as one
    std::vector<Stretch> stretches;
    for (std::size_t i = 1; i < line.points.size(); ++i) {
        const double width = line.widths[i];
        const bool goes_on = !stretches.empty() && std::abs(width - stretches.back().width) <= same * stretches.back().width;
        if (goes_on) {
            stretches.back().last = i;
        } else {
            stretches.push_back({i - 1, i, width});
        }
    }
    return stretches;
}

/// The rims of a mesh: directed edges that no other triangle has the other way round, chained.
Region rims_of(const TriangleMesh& mesh) {
    std::map<std::pair<int, int>, int> edges;
    for (const auto& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k) ++edges[{t[k], t[(k + 1) % 3]}];
    std::map<int, std::vector<int>> next;
    for (const auto& [edge, count] : edges)
        if (!edges.contains({edge.second, edge.first})) next[edge.first].push_back(edge.second);
    Region rims;
    while (!next.empty()) {
        std::vector<Point> ring;
        for (auto at = next.begin(); at != next.end();) {
            const SpacePoint p = mesh.positions[static_cast<std::size_t>(at->first)];
            ring.push_back({p.x, p.y});
            const int to = at->second.back();
            at->second.pop_back();
            if (at->second.empty()) next.erase(at);
            at = next.find(to);
        }
        rims.push_back(std::move(ring));
    }
    return rims;
}

class PatternDrawing {
  public:
    PatternDrawing(const SurfacePattern& pattern, const Box& canvas, double pixels)
        : pattern_(pattern), scale_(pixels / width(canvas)) {
        const Box pixels_box{scale_ * canvas.low, scale_ * canvas.high};
        text_ = svg_root_tag(pixels_box, true) + '\n';
    }

    std::string draw() {
        add_outlines();
        for (const NamedMesh& mesh : pattern_.laid) add_laid(mesh);
        for (const PatternLine& line : pattern_.lines) add_line(line);
        add_shapes();
        return std::move(text_ += "</svg>\n");
    }

  private:
    const SurfacePattern& pattern_;
    double scale_;
    std::string text_;

    void add_outlines() {
        text_ += "<defs>\n";
        for (std::size_t i = 0; i < pattern_.shapes.size(); ++i)
            text_ += "<path id=\"s" + std::to_string(i) + "\" fill-rule=\"evenodd\" d=\"" +
                     outline_data(pattern_.shapes[i].outline) + "\"/>\n";
        text_ += "</defs>\n";
    }

    /// From low to high.
    void add_shapes() {
        std::vector<std::size_t> order(pattern_.placed.size());
        std::iota(order.begin(), order.end(), std::size_t{0});
        std::ranges::stable_sort(order, {}, [&](std::size_t i) { return pattern_.placed[i].position.z; });
        for (const std::size_t i : order) add_shape(pattern_.placed[i]);
    }

    void add_shape(const PatternShape& shape) {
        const SpacePoint x = scale_ * shape.size.x * shape.axes[0], y = scale_ * shape.size.y * shape.axes[1];
        const SpacePoint p = scale_ * shape.position;
        // SVG's y points down: so do the outline's own and what it is mapped to
        text_ += "<use xlink:href=\"#s" + std::to_string(shape.shape) + "\" fill=\"" + svg_color_text(shape.color) +
                 "\" transform=\"matrix(" + numbers({x.x, -x.y, -y.x, y.y, p.x, -p.y}) + ")\"/>\n";
    }

    void add_line(const PatternLine& line) {
        for (const Stretch& stretch : stretches_of(line)) {
            Path path{pixel(line.points[stretch.first]), {}, false};
            for (std::size_t i = stretch.first + 1; i <= stretch.last; ++i)
                path.segments.push_back(line_to(pixel(line.points[i])));
            text_ += "<path fill=\"none\" stroke-linecap=\"round\" stroke-linejoin=\"round\" stroke=\"" +
                     svg_color_text(line.color) + "\" stroke-width=\"" + numbers({scale_ * stretch.width}) + "\" d=\"" +
                     svg_path_data({path}, digits) + "\"/>\n";
        }
    }

    void add_laid(const NamedMesh& mesh) {
        Region rims = rims_of(mesh.mesh);
        for (std::vector<Point>& ring : rims)
            for (Point& p : ring) p = scale_ * p;
        text_ += "<path fill=\"" + svg_color_text(mesh.color) + "\" d=\"" + outline_data(rims) + "\"/>\n";
    }

    Point pixel(SpacePoint p) const { return {scale_ * p.x, scale_ * p.y}; }

    static std::string numbers(std::initializer_list<double> values) {
        std::string text;
        for (const double value : values) text += (text.empty() ? "" : " ") + svg_number(value, digits);
        return text;
    }
};

}  // namespace

std::string pattern_svg(const SurfacePattern& pattern, const Box& canvas, double width) {
    return PatternDrawing(pattern, canvas, width).draw();
}

}  // namespace rinceau
