#include "analyzer/outline_deviation.h"

#include <algorithm>
#include <cmath>
#include <limits>

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

/// A segment with both its ends.
struct Piece {
    Point from;
    Segment segment;

    Piece reversed() const { return {segment.to, {segment.control2, segment.control1, from, segment.straight}}; }
};

/// The path's segments, a closing line of some length among them.
std::vector<Piece> pieces_of(const Path& path) {
    std::vector<Piece> pieces;
    pieces.reserve(path.segments.size() + 1);
    Point from = path.start;
    for (const Segment& segment : path.segments) {
        pieces.push_back({from, segment});
        from = segment.to;
    }
    if (path.closed && !(from == path.start)) pieces.push_back({from, line_to(path.start)});
    return pieces;
}

/// The largest distance of corresponding points of pieces k of `a` and k + shift of `b`; infinite beyond `limit` or if they
/// are of different kinds.
double apart(const std::vector<Piece>& a, const std::vector<Piece>& b, std::size_t shift, double limit) {
    double largest = 0;
    for (std::size_t k = 0; k < a.size() && largest <= limit * limit; ++k) {
        const Piece& s = a[k];
        const Piece& t = b[(k + shift) % b.size()];
        if (s.segment.straight != t.segment.straight) return std::numeric_limits<double>::infinity();
        largest = std::max({largest, norm(s.from - t.from), norm(s.segment.to - t.segment.to)});
        if (s.segment.straight) continue;
        largest = std::max({largest, norm(s.segment.control1 - t.segment.control1),
                            norm(s.segment.control2 - t.segment.control2)});
    }
    return largest <= limit * limit ? std::sqrt(largest) : std::numeric_limits<double>::infinity();
}

double bound_of_likes(const Path& a, const Path& b, double limit) {
    const std::vector<Piece> p = pieces_of(a);
    std::vector<Piece> q = pieces_of(b);
    if (a.closed != b.closed || p.size() != q.size()) return std::numeric_limits<double>::infinity();
    if (p.empty()) return abs(a.start - b.start);
    const std::size_t shifts = a.closed ? p.size() : 1;
    double least = std::numeric_limits<double>::infinity();
    for (int direction = 0; direction < 2; ++direction) {
        for (std::size_t shift = 0; shift < shifts && least > limit; ++shift) {
            if (norm(p.front().from - q[shift].from) <= limit * limit) least = std::min(least, apart(p, q, shift, limit));
        }
        std::ranges::reverse(q);
        for (Piece& piece : q) piece = piece.reversed();
    }
    return least;
}

/// An upper bound of the deviation of outlines that are written alike but for their direction and start: the largest
/// distance of corresponding points; infinite beyond `limit`. A curve lies within the hull of its points, and so does the
/// difference of two curves.
double bound_of_likes(const std::vector<Path>& a, const std::vector<Path>& b, double limit) {
    if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
    double largest = 0;
    for (std::size_t i = 0; i < a.size() && largest <= limit; ++i) largest = std::max(largest, bound_of_likes(a[i], b[i], limit));
    return largest;
}

double area_of(const std::vector<Path>& paths, double accuracy) {
    double sum = 0;
    for (const Path& path : paths) sum += signed_area(flattened(path, accuracy));
    return std::abs(sum);
}

}  // namespace

double outline_deviation(const std::vector<Path>& a, const std::vector<Path>& b, const DeviationOptions& options) {
    const double bound = bound_of_likes(a, b, options.small);
    if (bound <= options.small) return bound;
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
