#include "analyzer/outline_deviation.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "geometry/box_tree.h"
#include "geometry/cubic_bezier.h"
#include "geometry/polygon.h"

namespace rinceau {
namespace {

constexpr int samples_per_segment = 8;
/// Up to this many edges trying each is faster than asking a tree.
constexpr std::size_t edges_without_tree = 32;

struct Edge {
    Point from;
    Point to;
};

/// An outline to which distances are asked for.
struct Target {
    std::vector<Edge> edges;
    BoxTree tree;
};

Target target_of(const std::vector<Path>& paths, double accuracy) {
    Target target;
    for (const Path& path : paths) {
        const std::vector<Point> line = flattened(path, accuracy);
        for (std::size_t i = 0; i + 1 < line.size(); ++i) target.edges.push_back({line[i], line[i + 1]});
        if (line.size() == 1 || path.closed) target.edges.push_back({line.back(), line.front()});
    }
    if (target.edges.size() <= edges_without_tree) return target;
    std::vector<Box> boxes;
    for (const Edge& edge : target.edges) boxes.push_back(including(including(Box{}, edge.from), edge.to));
    target.tree = BoxTree(boxes);
    return target;
}

double distance(const Target& target, Point p, double reach) {
    double least = reach;
    const auto try_edge = [&](std::size_t i) {
        least = std::min(least, distance_to_segment(p, target.edges[i].from, target.edges[i].to));
        return true;
    };
    if (target.edges.size() > edges_without_tree) {
        target.tree.visit(grown({p, p}, reach), try_edge);
    } else {
        for (std::size_t i = 0; i < target.edges.size(); ++i) try_edge(i);
    }
    return least;
}

std::vector<Point> samples_of(const std::vector<Path>& paths) {
    std::vector<Point> samples;
    for (const Path& path : paths) {
        Point from = path.start;
        samples.push_back(from);
        const auto sample = [&](const Segment& segment) {
            const CubicBezier curve{from, segment.control1, segment.control2, segment.to};
            for (int k = 1; k <= samples_per_segment; ++k) {
                const double t = static_cast<double>(k) / samples_per_segment;
                samples.push_back(segment.straight ? from + t * (segment.to - from) : evaluate(curve, t));
            }
            from = segment.to;
        };
        for (const Segment& segment : path.segments) sample(segment);
        if (path.closed && !(from == path.start)) sample(line_to(path.start));
    }
    return samples;
}

double one_way(const std::vector<Path>& from, const Target& to, double reach) {
    double largest = 0;
    for (const Point p : samples_of(from)) {
        largest = std::max(largest, distance(to, p, reach));
        if (largest >= reach) return reach;
    }
    return largest;
}

/// An upper bound of the deviation of outlines that are written alike: the largest distance of corresponding points. A curve
/// lies within the hull of its points, and so does the difference of two curves.
std::optional<double> bound_of_likes(const std::vector<Path>& a, const std::vector<Path>& b) {
    if (a.size() != b.size()) return std::nullopt;
    double largest = 0;
    const auto compare = [&](Point p, Point q) { largest = std::max(largest, norm(p - q)); };
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (a[i].closed != b[i].closed || a[i].segments.size() != b[i].segments.size()) return std::nullopt;
        compare(a[i].start, b[i].start);
        for (std::size_t k = 0; k < a[i].segments.size(); ++k) {
            const Segment& s = a[i].segments[k];
            const Segment& t = b[i].segments[k];
            if (s.straight != t.straight) return std::nullopt;
            compare(s.to, t.to);
            if (s.straight) continue;
            compare(s.control1, t.control1);
            compare(s.control2, t.control2);
        }
    }
    return std::sqrt(largest);
}

double area_of(const std::vector<Path>& paths, double accuracy) {
    double sum = 0;
    for (const Path& path : paths) sum += signed_area(flattened(path, accuracy));
    return std::abs(sum);
}

}  // namespace

double outline_deviation(const std::vector<Path>& a, const std::vector<Path>& b, const DeviationOptions& options) {
    const std::optional<double> bound = bound_of_likes(a, b);
    if (bound && *bound <= options.small) return *bound;
    if (a.empty() || b.empty()) return a.empty() && b.empty() ? 0 : options.reach;
    const double forth = one_way(a, target_of(b, options.accuracy), options.reach);
    if (forth >= options.reach) return options.reach;
    return std::max(forth, one_way(b, target_of(a, options.accuracy), options.reach));
}

bool wind_alike(const std::vector<Path>& a, const std::vector<Path>& b, double deviation) {
    if (a.size() < 2 && b.size() < 2) return true;
    // A band of the deviation's width along both outlines is the most that the areas may differ by.
    return std::abs(area_of(a, deviation) - area_of(b, deviation)) <= 2 * deviation * (length(a) + length(b));
}

}  // namespace rinceau
