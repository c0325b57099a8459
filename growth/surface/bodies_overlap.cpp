// Li et al. 2010, section 4.4.1, test with Bullet's meshes in single precision, which report contact across gaps of 1e-4 of
// the size in most cases; touching shapes are the rule in patterns, so the test is made here, in double precision and on the
// convex bodies that stand for the shapes.

#include "growth/surface/bodies_overlap.h"

#include <algorithm>
#include <cmath>

#include "growth/surface/convex_overlap.h"
#include "growth/surface/outlines_meet.h"

namespace rinceau {
namespace {

constexpr double touching = 1e-9;        // of the size: overlap that does not count
constexpr double opposed = -0.3;         // cosine of the surface's normals on both faces of a thin sheet
constexpr double seen_from_above = 0.8;  // cosine of the bodies' third axes from which outlines are compared in one plane
constexpr double parallel = 1e-6;        // sine of the angle of two edges without an axis of their own

/// Two boxes in the frame of the first: Gottschalk, Lin, Manocha 1996, "OBBTree", section 5.
struct BoxPair {
    std::array<double, 3> a, b;                   ///< half lengths
    std::array<double, 3> apart;                  ///< centre of the second
    std::array<std::array<double, 3>, 3> turn;    ///< [i][j]: axis i of the first along axis j of the second
    std::array<std::array<double, 3>, 3> turned;  ///< its sizes
};

BoxPair box_pair(const CollisionBody& a, const CollisionBody& b, double shrink_a, double shrink_b) {
    BoxPair pair;
    pair.a = {shrink_a * a.half.x, shrink_a * a.half.y, shrink_a * a.half.z};
    pair.b = {shrink_b * b.half.x, shrink_b * b.half.y, shrink_b * b.half.z};
    const SpacePoint apart = b.centre - a.centre;
    for (std::size_t i = 0; i < 3; ++i) {
        pair.apart[i] = dot(apart, a.axes[i]);
        for (std::size_t j = 0; j < 3; ++j) {
            pair.turn[i][j] = dot(a.axes[i], b.axes[j]);
            pair.turned[i][j] = std::abs(pair.turn[i][j]);
        }
    }
    return pair;
}

bool parted(double distance, double reach) { return std::abs(distance) >= reach * (1 - touching); }

bool parted_by_a_side(const BoxPair& p) {
    for (std::size_t i = 0; i < 3; ++i) {
        const auto& t = p.turned[i];
        if (parted(p.apart[i], p.a[i] + p.b[0] * t[0] + p.b[1] * t[1] + p.b[2] * t[2])) return true;
    }
    for (std::size_t j = 0; j < 3; ++j) {
        const double distance = p.apart[0] * p.turn[0][j] + p.apart[1] * p.turn[1][j] + p.apart[2] * p.turn[2][j];
        if (parted(distance, p.b[j] + p.a[0] * p.turned[0][j] + p.a[1] * p.turned[1][j] + p.a[2] * p.turned[2][j]))
            return true;
    }
    return false;
}

bool parted_by_two_edges(const BoxPair& p) {
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) {
            if (1 - p.turn[i][j] * p.turn[i][j] < parallel * parallel) continue;
            const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3, j1 = (j + 1) % 3, j2 = (j + 2) % 3;
            const double distance = p.apart[i2] * p.turn[i1][j] - p.apart[i1] * p.turn[i2][j];
            const double reach = p.a[i1] * p.turned[i2][j] + p.a[i2] * p.turned[i1][j] + p.b[j1] * p.turned[i][j2] +
                                 p.b[j2] * p.turned[i][j1];
            if (parted(distance, reach)) return true;
        }
    return false;
}

bool parts_overlap(const CollisionBody& a, const CollisionBody& b, double shrink_a, double shrink_b) {
    if (!boxes_overlap(a, b, shrink_a, shrink_b)) return false;
    if (a.collide == CollideAs::box && b.collide == CollideAs::box) return true;
    const bool outline = a.collide == CollideAs::outline || b.collide == CollideAs::outline;
    if (outline && std::abs(dot(a.axes[2], b.axes[2])) > seen_from_above) return outlines_meet(a, b, shrink_a, shrink_b);
    return convex_bodies_overlap(a, b, shrink_a, shrink_b);
}

}  // namespace

bool boxes_overlap(const CollisionBody& a, const CollisionBody& b, double shrink_a, double shrink_b) {
    const BoxPair pair = box_pair(a, b, shrink_a, shrink_b);
    return !parted_by_a_side(pair) && !parted_by_two_edges(pair);
}

bool bodies_overlap(const CollisionBody& a, const CollisionBody& b, double shrink_a, double shrink_b) {
    const SpacePoint apart = a.centre - b.centre;
    const double reach = shrink_a * radius_of(a) + shrink_b * radius_of(b);
    if (dot(apart, apart) >= reach * reach) return false;
    if (dot(a.normal, b.normal) < opposed && (a.below > 0 || b.below > 0))
        return parts_overlap(above_surface(a), above_surface(b), shrink_a, shrink_b);
    return parts_overlap(a, b, shrink_a, shrink_b);
}

}  // namespace rinceau
