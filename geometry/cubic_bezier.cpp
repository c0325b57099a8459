#include "geometry/cubic_bezier.h"

#include <array>
#include <cassert>

namespace rinceau {

namespace {

// Gauss-Legendre rule of 8 points on [-1, 1]: the positive nodes with their weights; the others are mirror images.
constexpr std::array<double, 4> gauss_nodes{0.1834346424956498, 0.5255324099163290, 0.7966664774136267, 0.9602898564975363};
constexpr std::array<double, 4> gauss_weights{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                              0.1012285362903763};

// Halving ends here: a part this small adds nothing that a double of the whole length could hold.
constexpr int deepest_halving = 26;
constexpr double relative_accuracy = 1e-11;
constexpr int most_flat_pieces = 4096;

double gauss_length(const CubicBezier& curve, double from, double to) {
    const double middle = 0.5 * (from + to);
    const double half = 0.5 * (to - from);
    double sum = 0;
    for (std::size_t i = 0; i < gauss_nodes.size(); ++i) {
        sum += gauss_weights[i] * (abs(derivative(curve, middle - half * gauss_nodes[i])) +
                                   abs(derivative(curve, middle + half * gauss_nodes[i])));
    }
    return half * sum;
}

double refined_length(const CubicBezier& curve, double from, double to, double estimate, double allowed, int depth) {
    const double middle = 0.5 * (from + to);
    const double first = gauss_length(curve, from, middle);
    const double second = gauss_length(curve, middle, to);
    if (depth == 0 || std::abs(first + second - estimate) <= allowed) return first + second;
    return refined_length(curve, from, middle, first, 0.5 * allowed, depth - 1) +
           refined_length(curve, middle, to, second, 0.5 * allowed, depth - 1);
}

// Includes the curve's points where a x'' + b x' + c, one coordinate of the derivative as a polynomial in t, vanishes.
Box including_roots(Box box, const CubicBezier& curve, double a, double b, double c) {
    const auto include = [&](double t) {
        if (t > 0 && t < 1) box = including(box, evaluate(curve, t));
    };
    const double discriminant = b * b - 4 * a * c;
    if (!(discriminant >= 0)) return box;
    // The form without cancellation; it serves a = 0 and b = 0 as well (a division by zero gives a t outside (0, 1)).
    const double q = -0.5 * (b + std::copysign(std::sqrt(discriminant), b));
    if (a != 0) include(q / a);
    if (q != 0) include(c / q);
    return box;
}

double control_polygon_length(const CubicBezier& curve) {
    return abs(curve.control1 - curve.from) + abs(curve.control2 - curve.control1) + abs(curve.to - curve.control2);
}

}  // namespace

Point evaluate(const CubicBezier& curve, double t) {
    const double s = 1 - t;
    return s * s * s * curve.from + 3 * s * s * t * curve.control1 + 3 * s * t * t * curve.control2 + t * t * t * curve.to;
}

Point derivative(const CubicBezier& curve, double t) {
    const double s = 1 - t;
    return 3 * s * s * (curve.control1 - curve.from) + 6 * s * t * (curve.control2 - curve.control1) +
           3 * t * t * (curve.to - curve.control2);
}

std::pair<CubicBezier, CubicBezier> split(const CubicBezier& curve, double t) {
    const auto between = [t](Point a, Point b) { return a + t * (b - a); };
    const Point a = between(curve.from, curve.control1);
    const Point b = between(curve.control1, curve.control2);
    const Point c = between(curve.control2, curve.to);
    const Point ab = between(a, b);
    const Point bc = between(b, c);
    const Point middle = between(ab, bc);
    return {{curve.from, a, ab, middle}, {middle, bc, c, curve.to}};
}

Box bounds(const CubicBezier& curve) {
    const Box ends = including(including(Box{}, curve.from), curve.to);
    // A curve whose control points lie in the box of its ends lies there as well.
    if (contains(ends, including(including(Box{}, curve.control1), curve.control2))) return ends;
    const Point c = curve.control1 - curve.from;
    const Point b = 2 * (curve.control2 - 2 * curve.control1 + curve.from);
    const Point a = curve.to - 3 * curve.control2 + 3 * curve.control1 - curve.from;
    // Each coordinate's extrema may widen the box along that coordinate only; the points lie on the curve in any case.
    return including_roots(including_roots(ends, curve, a.x, b.x, c.x), curve, a.y, b.y, c.y);
}

double arc_length(const CubicBezier& curve) {
    const double polygon = control_polygon_length(curve);
    if (!(polygon > 0)) return 0;
    return refined_length(curve, 0, 1, gauss_length(curve, 0, 1), relative_accuracy * polygon, deepest_halving);
}

std::vector<Point> flattened(const CubicBezier& curve, double deviation) {
    assert(deviation > 0);
    // Wang's bound: n chords of a cubic deviate by at most 6/8 of its largest second difference over n^2.
    const double bend =
        std::max(abs(curve.from - 2 * curve.control1 + curve.control2), abs(curve.control1 - 2 * curve.control2 + curve.to));
    const double wanted = std::ceil(std::sqrt(0.75 * bend / deviation));
    const int count = wanted < most_flat_pieces ? std::max(1, static_cast<int>(wanted)) : most_flat_pieces;
    std::vector<Point> points;
    points.reserve(static_cast<std::size_t>(count));
    for (int i = 1; i < count; ++i) points.push_back(evaluate(curve, static_cast<double>(i) / count));
    points.push_back(curve.to);
    return points;
}

std::vector<ArcSample> arc_samples(const CubicBezier& curve, int pieces) {
    assert(pieces >= 1);
    std::vector<ArcSample> samples;
    samples.reserve(static_cast<std::size_t>(pieces) * 2 * gauss_nodes.size());
    const double half = 0.5 / pieces;
    const auto add = [&](double t, double weight) {
        samples.push_back({evaluate(curve, t), half * weight * abs(derivative(curve, t))});
    };
    for (int piece = 0; piece < pieces; ++piece) {
        const double middle = (2 * piece + 1) * half;
        for (std::size_t i = gauss_nodes.size(); i-- > 0;) add(middle - half * gauss_nodes[i], gauss_weights[i]);
        for (std::size_t i = 0; i < gauss_nodes.size(); ++i) add(middle + half * gauss_nodes[i], gauss_weights[i]);
    }
    return samples;
}

}  // namespace rinceau
