#include "analyzer/outline_distance.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

namespace rinceau {

namespace {

constexpr double longest_edge = 0.15;
constexpr double edge_deviation = 1e-3;
constexpr int most_parts = 4096;

/// Chords of n equal parameter steps deviate by at most max|B''| / (8 n^2), and |B''| <= 6 max|second difference|.
int parts_of(const OutlinePiece& piece) {
    const CubicBezier& c = piece.curve;
    double polygon = abs(c.to - c.from);
    double bend = 0;
    if (!piece.straight) {
        polygon = abs(c.control1 - c.from) + abs(c.control2 - c.control1) + abs(c.to - c.control2);
        bend = 6 * std::max(abs(c.from - 2 * c.control1 + c.control2), abs(c.control1 - 2 * c.control2 + c.to));
    }
    const double parts = std::max(polygon / longest_edge, std::sqrt(bend / (8 * edge_deviation)));
    return static_cast<int>(std::ceil(std::clamp(parts, 1.0, double{most_parts})));
}

Point point_at(const OutlinePiece& piece, double t) {
    return piece.straight ? piece.curve.from + t * (piece.curve.to - piece.curve.from) : evaluate(piece.curve, t);
}

Point direction_at(const OutlinePiece& piece, double t) {
    return piece.straight ? piece.curve.to - piece.curve.from : derivative(piece.curve, t);
}

struct Foot {
    double squared = 0;  ///< squared distance from the edge
    double share = 0;    ///< of the edge, 0..1
};

Foot foot_on(const OutlineEdge& edge, Point p) {
    const Point along = edge.to - edge.from;
    const Point to_p = p - edge.from;
    const double squared_length = norm(along);
    const double share = squared_length > 0 ? std::clamp(dot(to_p, along) / squared_length, 0.0, 1.0) : 0.0;
    return {norm(to_p - share * along), share};
}

/// A point of the true curves near an edge's nearest point.
struct Nearest {
    std::size_t edge = 0;
    Point at;
    Point direction;  ///< of the curve there
};

/// Looks up nearest points of an outline for points that come along a curve: the last answer is where the search starts.
class NearestOnOutline {
  public:
    explicit NearestOnOutline(const FineOutline& outline) : outline_(outline) {}

    bool within(Point p, double distance) {
        const double sure = distance - edge_deviation;
        if (sure > 0 && some_near_last(p, sure * sure)) return true;
        if (sure <= 0) {
            last_ = near_last(p);
            if (abs(on_curve(last_, p).at - p) <= distance) return true;
        }
        last_ = nearest_edge(p);
        const double squared = foot_on(outline_.edges[last_], p).squared;
        if (sure > 0 && squared <= sure * sure) return true;
        if (squared > (distance + edge_deviation) * (distance + edge_deviation)) return false;
        return abs(on_curve(last_, p).at - p) <= distance;
    }

    /// For copies that are nearly in place.
    Nearest nearest(Point p) {
        constexpr double near = 0.02;  // unit lengths: beyond, the search starts afresh
        last_ = near_last(p);
        if (foot_on(outline_.edges[last_], p).squared > near * near) last_ = nearest_edge(p);
        return on_curve(last_, p);
    }

  private:
    /// Is one of the edges about the last answer near enough? It becomes the last answer.
    bool some_near_last(Point p, double squared) {
        const std::size_t count = outline_.edges.size();
        for (std::size_t edge : {last_, last_ + 1, last_ + count - 1, last_ + 2, last_ + count - 2 % count}) {
            while (edge >= count) edge -= count;
            if (foot_on(outline_.edges[edge], p).squared > squared) continue;
            last_ = edge;
            return true;
        }
        return false;
    }

    /// The best of the edges about the last answer.
    std::size_t near_last(Point p) const {
        const std::size_t count = outline_.edges.size();
        std::size_t best = last_;
        double squared = foot_on(outline_.edges[last_], p).squared;
        for (std::size_t edge : {last_ + 1, last_ + count - 1, last_ + 2, last_ + count - 2 % count}) {
            while (edge >= count) edge -= count;
            const double d = foot_on(outline_.edges[edge], p).squared;
            if (d < squared) best = edge, squared = d;
        }
        return best;
    }

    std::size_t nearest_edge(Point p) const {
        std::size_t best = 0;
        double squared = std::numeric_limits<double>::infinity();
        for (std::size_t edge = 0; edge < outline_.edges.size(); ++edge) {
            const double d = foot_on(outline_.edges[edge], p).squared;
            if (d < squared) best = edge, squared = d;
        }
        return best;
    }

    /// Newton steps for the foot of the perpendicular, kept on the piece.
    Nearest on_curve(std::size_t edge_index, Point p) const {
        const OutlineEdge& edge = outline_.edges[edge_index];
        const OutlinePiece& piece = outline_.pieces[static_cast<std::size_t>(edge.piece)];
        double t = edge.t_from + foot_on(edge, p).share * (edge.t_to - edge.t_from);
        for (int step = 0; step < 3 && !piece.straight; ++step) {
            const Point along = direction_at(piece, t);
            if (!(norm(along) > 0)) break;
            t = std::clamp(t + dot(p - point_at(piece, t), along) / norm(along), 0.0, 1.0);
        }
        return {edge_index, point_at(piece, t), direction_at(piece, t)};
    }

    const FineOutline& outline_;
    std::size_t last_ = 0;
};

bool one_way_within(const FineOutline& a, const Similarity& map, const FineOutline& b, double distance) {
    NearestOnOutline target(b);
    for (const OutlineEdge& edge : a.edges)
        if (!target.within(apply(map, edge.from), distance) ||
            (edge.last_of_line && !target.within(apply(map, edge.to), distance)))
            return false;
    return true;
}

/// One Gauss-Newton step for z -> (1 + u) z + v, u and v complex, minimising the distances to the curves.
Similarity refining_step(const FineOutline& a, const Similarity& map, const FineOutline& b) {
    constexpr double along_weight = 0.01;  // keeps what distances across the curve leave open where it was
    NearestOnOutline target(b);
    Eigen::Matrix4d normal = Eigen::Matrix4d::Zero();
    Eigen::Vector4d right = Eigen::Vector4d::Zero();
    for (std::size_t i = 0; i < a.edges.size(); ++i) {
        const OutlineEdge& edge = a.edges[i];
        const OutlineEdge& before = a.edges[(i + a.edges.size() - 1) % a.edges.size()];
        const Point p = apply(map, edge.from);
        const Nearest foot = target.nearest(p);
        const double speed = abs(foot.direction);
        const Point along = speed > 0 ? foot.direction / speed : Point{1, 0};
        const Point gap = foot.at - p;
        const double weight = abs(edge.to - edge.from) + abs(before.to - before.from);
        for (const auto& [axis, w] :
             {std::pair{Point{-along.y, along.x}, weight}, std::pair{along, along_weight * weight}}) {
            const Eigen::Vector4d row(dot(axis, p), dot(axis, {-p.y, p.x}), axis.x, axis.y);
            normal += w * row * row.transpose();
            right += w * dot(axis, gap) * row;
        }
    }
    const Eigen::Vector4d step = normal.ldlt().solve(right);
    if (!step.allFinite()) return map;
    return Similarity{{1 + step[0], step[1]}, {step[2], step[3]}, false} * map;
}

}  // namespace

FineOutline fine_outline(const Outline& outline, Point center, double unit) {
    FineOutline fine;
    fine.pieces.reserve(outline.pieces.size());
    constexpr std::size_t usual_parts = 8;
    fine.edges.reserve(usual_parts * outline.pieces.size());
    for (const OutlinePiece& scene_piece : outline.pieces) {
        const OutlinePiece piece = in_frame(scene_piece, center, unit);
        const int parts = parts_of(piece);
        Point from = piece.curve.from;
        if (!fine.edges.empty() && fine.edges.back().to != from) fine.edges.back().last_of_line = true;
        for (int i = 0; i < parts; ++i) {
            const double t_from = static_cast<double>(i) / parts;
            const double t_to = static_cast<double>(i + 1) / parts;
            const Point to = i + 1 == parts ? piece.curve.to : point_at(piece, t_to);
            fine.edges.push_back({from, to, static_cast<int>(fine.pieces.size()), t_from, t_to, false});
            from = to;
        }
        fine.pieces.push_back(piece);
    }
    if (!fine.edges.empty()) fine.edges.back().last_of_line = true;
    return fine;
}

bool within_distance(const FineOutline& a, const Similarity& map, const FineOutline& b, double distance) {
    if (a.edges.empty() || b.edges.empty()) return a.edges.empty() && b.edges.empty();
    return one_way_within(a, map, b, distance) && one_way_within(b, inverse(map), a, distance);
}

Similarity refined(const FineOutline& a, const Similarity& map, const FineOutline& b) {
    if (a.edges.empty() || b.edges.empty()) return map;
    constexpr int steps = 2;
    Similarity better = map;
    for (int i = 0; i < steps; ++i) better = refining_step(a, better, b);
    return better;
}

}  // namespace rinceau
