// Lines and areas from a drawing. The places that messages name are those of the drawing's own space: y down.

#include "growth/strokes.h"

#include <algorithm>
#include <set>
#include <utility>

#include "geometry/box_tree.h"
#include "geometry/orientation.h"
#include "geometry/polygon.h"
#include "scene/input_error.h"
#include "scene/svg_number.h"

namespace rinceau {
namespace {

bool is_closed(const Path& path) {
    return path.closed || (path.segments.size() > 1 && path.segments.back().to == path.start);
}

/// The path's corners without one that equals the corner before it; a closed path begins and ends with the same.
Polyline polyline_of(const Path& path, double deviation) {
    Polyline line;
    const auto add = [&line](Point p) {
        if (line.empty() || !(line.back() == p)) line.push_back(p);
    };
    for (const Point p : flattened(path, deviation)) add(p);
    if (path.closed && !line.empty()) add(line.front());
    return line;
}

struct OutlineEdge {
    Point a, b;
    std::size_t outline = 0;
};

std::vector<OutlineEdge> edges_of(const Region& outlines) {
    std::vector<OutlineEdge> edges;
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        const std::vector<Point>& ring = outlines[i];
        for (std::size_t k = 0; k < ring.size(); ++k) edges.push_back({ring[k], ring[(k + 1) % ring.size()], i});
    }
    return edges;
}

[[noreturn]] void fail_crossing(const std::string& label, bool with_itself, Point at) {
    const std::string which = with_itself ? "an outline of the region crosses itself" : "two outlines of the region cross";
    constexpr int digits = 6;
    throw InputError({label}, which + " near (" + svg_number(at.x, digits) + ", " + svg_number(-at.y, digits) +
                                  "); outlines may lie inside one another or apart");
}

/// Throws if edges cross; else the pairs of outlines that touch. Touching outlines may cross at the very points of contact.
std::set<std::pair<std::size_t, std::size_t>> touching_outlines(const Region& outlines, const std::string& label) {
    const std::vector<OutlineEdge> edges = edges_of(outlines);
    std::vector<Box> boxes;
    boxes.reserve(edges.size());
    for (const OutlineEdge& edge : edges) boxes.push_back(including(including(Box{}, edge.a), edge.b));
    const BoxTree tree(boxes);
    std::set<std::pair<std::size_t, std::size_t>> touching;
    for (std::size_t i = 0; i < edges.size(); ++i) {
        tree.visit(boxes[i], [&](std::size_t j) {
            if (j <= i) return true;
            const OutlineEdge &e = edges[i], &f = edges[j];
            const SegmentContact contact = segment_contact(e.a, e.b, f.a, f.b);
            if (contact == SegmentContact::crossed) {
                const auto crossing = segment_crossing(e.a, e.b, f.a, f.b);
                fail_crossing(label, e.outline == f.outline, crossing ? crossing->at : e.a);
            }
            if (contact == SegmentContact::touching && e.outline != f.outline) touching.insert({e.outline, f.outline});
            return true;
        });
    }
    return touching;
}

/// Outlines that only touch lie apart or inside one another.
void expect_apart_or_nested(const Region& outlines, std::pair<std::size_t, std::size_t> pair, const std::string& label) {
    const Region first{outlines[pair.first]}, second{outlines[pair.second]};
    const Region common = intersection_of(first, second);
    const double shared = area(common), least = std::min(area(first), area(second));
    constexpr double rounding = 1e-6;  // of the areas: clipping works on a grid
    if (shared > rounding * least && shared < (1 - rounding) * least) fail_crossing(label, false, center(bounds(common)));
}

}  // namespace

std::vector<Polyline> polylines_of(const Scene& scene, double deviation) {
    std::vector<Polyline> lines;
    for (const Element& element : scene.elements) {
        for (const Path& path : element.paths) {
            Polyline line = polyline_of(path, deviation);
            if (line.size() > 1) lines.push_back(std::move(line));
        }
    }
    return lines;
}

double length_of(const Polyline& line) {
    double sum = 0;
    for (std::size_t i = 1; i < line.size(); ++i) sum += abs(line[i] - line[i - 1]);
    return sum;
}

std::vector<Point> cut_evenly(const Polyline& line, std::size_t count) {
    const double length = length_of(line);
    std::vector<Point> cuts;
    double passed = 0;
    std::size_t corner = 1;
    for (std::size_t i = 0; i <= count; ++i) {
        const double at = length * static_cast<double>(i) / static_cast<double>(count);
        double edge = abs(line[corner] - line[corner - 1]);
        while (corner + 1 < line.size() && passed + edge < at) {
            passed += edge;
            ++corner;
            edge = abs(line[corner] - line[corner - 1]);
        }
        const double share = edge > 0 ? std::clamp((at - passed) / edge, 0.0, 1.0) : 0;
        cuts.push_back(line[corner - 1] + share * (line[corner] - line[corner - 1]));
    }
    return cuts;
}

Region region_of(const Scene& scene, double deviation, const std::string& label) {
    Region outlines;
    for (const Element& element : scene.elements) {
        for (const Path& path : element.paths) {
            if (!is_closed(path)) continue;
            Polyline ring = polyline_of(path, deviation);
            if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
            if (ring.size() > 2) outlines.push_back(std::move(ring));
        }
    }
    if (outlines.empty())
        throw InputError({label},
                         "expected closed outlines of a region, found none; close the lines that are to enclose it");
    for (const auto& pair : touching_outlines(outlines, label)) expect_apart_or_nested(outlines, pair, label);

    const double extent = diagonal(bounds(outlines));
    constexpr double least_share = 1e-9;  // of the extent's square: what clipping cannot tell from nothing
    if (!(area(outlines) > least_share * extent * extent))
        throw InputError({label}, "the outlines of the region enclose no area");
    return outlines;
}

}  // namespace rinceau
