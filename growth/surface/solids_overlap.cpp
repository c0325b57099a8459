// Hulls by the nearest point to the origin of all differences of corners (Wolfe 1976, "Finding the nearest point in a
// polytope"); outlines by the area of their intersection. Placing uses other ways: see bodies_overlap.cpp.

#include "growth/surface/solids_overlap.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace rinceau {
namespace {

constexpr double meets_origin = 1e-9;    // of the size
constexpr double nearly_parallel = 0.8;  // cosine
constexpr double no_area = 1e-7;         // of the smaller outline's area: rounding of the clipping

std::vector<SpacePoint> corners_of(const PlacedSolid& solid, double shrink) {
    const GrammarShape& shape = *solid.shape;
    std::vector<SpacePoint> corners = shape.mesh.positions;
    if (corners.empty())
        for (const double x : {shape.low.x, shape.high.x})
            for (const double y : {shape.low.y, shape.high.y})
                for (const double z : {shape.low.z, shape.high.z}) corners.push_back({x, y, z});
    const SpacePoint middle = 0.5 * (shape.low + shape.high), centre = centre_of(solid);
    for (SpacePoint& p : corners) {
        const SpacePoint from = shrink * (p - middle);
        p = centre + from.x * solid.size.x * solid.axes[0] + from.y * solid.size.y * solid.axes[1] +
            from.z * solid.size.z * solid.axes[2];
    }
    return corners;
}

SpacePoint farthest(const std::vector<SpacePoint>& points, SpacePoint along) {
    return *std::max_element(points.begin(), points.end(),
                             [along](SpacePoint p, SpacePoint q) { return dot(p, along) < dot(q, along); });
}

/// Points with weights that sum to 1.
struct Corral {
    std::array<SpacePoint, 4> points;
    std::array<double, 4> weights{};
    std::size_t count = 0;

    SpacePoint mean() const {
        SpacePoint sum;
        for (std::size_t i = 0; i < count; ++i) sum = sum + weights[i] * points[i];
        return sum;
    }
};

/// Weights (of any sign) of the point nearest to the origin of the flat through the points.
std::array<double, 4> flat_weights(const Corral& corral) {
    using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 5, 5>;
    const auto n = static_cast<Eigen::Index>(corral.count);
    Matrix system = Matrix::Zero(n + 1, n + 1);
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 5, 1> right = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 5, 1>::Zero(n + 1);
    right(n) = 1;
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = 0; j < n; ++j)
            system(i, j) = dot(corral.points[static_cast<std::size_t>(i)], corral.points[static_cast<std::size_t>(j)]);
        system(i, n) = system(n, i) = 1;
    }
    const auto solution = system.fullPivLu().solve(right).eval();
    std::array<double, 4> weights{};
    for (Eigen::Index i = 0; i < n; ++i) weights[static_cast<std::size_t>(i)] = solution(i);
    return weights;
}

/// Moves to the nearest point of the corral's hull and keeps the points that it needs.
void settle(Corral& corral) {
    constexpr double nothing = 1e-12;
    while (corral.count > 1) {
        const std::array<double, 4> wanted = flat_weights(corral);
        double way = 1;
        for (std::size_t i = 0; i < corral.count; ++i)
            if (wanted[i] <= nothing && corral.weights[i] > wanted[i])
                way = std::min(way, corral.weights[i] / (corral.weights[i] - wanted[i]));
        Corral kept;
        double sum = 0;
        for (std::size_t i = 0; i < corral.count; ++i) {
            const double weight = corral.weights[i] + way * (wanted[i] - corral.weights[i]);
            if (weight <= nothing) continue;
            kept.points[kept.count] = corral.points[i];
            kept.weights[kept.count++] = weight;
            sum += weight;
        }
        for (std::size_t i = 0; i < kept.count; ++i) kept.weights[i] /= sum;
        const bool settled = kept.count == corral.count;
        corral = kept;
        if (settled) return;
    }
}

bool hulls_overlap(const PlacedSolid& a, const PlacedSolid& b, double shrink) {
    const std::vector<SpacePoint> first = corners_of(a, shrink), second = corners_of(b, shrink);
    const auto difference = [&](SpacePoint along) { return farthest(first, along) - farthest(second, -1 * along); };
    const double size = shrink * (radius_of(a) + radius_of(b));
    Corral corral;
    corral.points[0] = difference(centre_of(b) - centre_of(a));
    corral.weights[0] = 1;
    corral.count = 1;
    double last = std::numeric_limits<double>::infinity();
    for (SpacePoint nearest = corral.points[0];;) {
        const double distance = abs(nearest);
        if (distance <= meets_origin * size || corral.count == 4) return true;
        const SpacePoint next = difference(-1 * nearest);
        if (dot(next, nearest) > 0) return false;
        if (!(distance < last)) return true;  // rounding has the last word
        last = distance;
        corral.points[corral.count] = next;
        corral.weights[corral.count++] = 0;
        settle(corral);
        nearest = corral.mean();
    }
}

Region outline_on(const PlacedSolid& solid, double shrink, SpacePoint origin, SpacePoint x, SpacePoint y) {
    const SpacePoint middle = 0.5 * (solid.shape->low + solid.shape->high), centre = centre_of(solid) - origin;
    Region region = solid.shape->outline;
    for (auto& ring : region)
        for (Point& p : ring) {
            const SpacePoint at = centre + shrink * (p.x - middle.x) * solid.size.x * solid.axes[0] +
                                  shrink * (p.y - middle.y) * solid.size.y * solid.axes[1];
            p = {dot(at, x), dot(at, y)};
        }
    return region;
}

bool outlines_overlap(const PlacedSolid& a, const PlacedSolid& b, double shrink) {
    const double side = dot(a.axes[2], b.axes[2]) < 0 ? -1 : 1;
    const SpacePoint normal = unit(a.axes[2] + side * b.axes[2]);
    const SpacePoint x = unit(cross(normal, a.axes[0])), y = cross(normal, x);
    const Region first = outline_on(a, shrink, centre_of(a), x, y), second = outline_on(b, shrink, centre_of(a), x, y);
    return area(intersection_of(first, second)) > no_area * std::min(area(first), area(second));
}

}  // namespace

SpacePoint centre_of(const PlacedSolid& solid) {
    const SpacePoint middle = 0.5 * (solid.shape->low + solid.shape->high);
    return solid.position + middle.x * solid.size.x * solid.axes[0] + middle.y * solid.size.y * solid.axes[1] +
           middle.z * solid.size.z * solid.axes[2];
}

double radius_of(const PlacedSolid& solid) {
    const SpacePoint extent = 0.5 * (solid.shape->high - solid.shape->low);
    return abs(SpacePoint{extent.x * solid.size.x, extent.y * solid.size.y, extent.z * solid.size.z});
}

bool solids_overlap(const PlacedSolid& a, const PlacedSolid& b, double shrink) {
    const SpacePoint apart = centre_of(a) - centre_of(b);
    const double reach = shrink * (radius_of(a) + radius_of(b));
    if (dot(apart, apart) >= reach * reach || !hulls_overlap(a, b, shrink)) return false;
    const bool by_outline = (a.shape->collide == CollideAs::outline || b.shape->collide == CollideAs::outline) &&
                            std::abs(dot(a.axes[2], b.axes[2])) > nearly_parallel;
    return !by_outline || outlines_overlap(a, b, shrink);
}

}  // namespace rinceau
