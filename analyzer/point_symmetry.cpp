#include "analyzer/point_symmetry.h"

#include <cmath>

#include "analyzer/align.h"

namespace rinceau {

namespace {

constexpr int most_rotations = 48;
constexpr double hopeless_residual = 0.05;  // of moments: far above what the geometric check lets pass

bool maps_to_itself(const Moments& moments, const FineOutline& outline, const Similarity& map, double distance) {
    return alignment_residual(moments, moments, arg(map.linear), map.mirrored) < hopeless_residual &&
           within_distance(outline, map, outline, distance);
}

/// Near-symmetric shapes pass single turns of wrong orders, never all of them.
bool has_order(const Moments& moments, const FineOutline& outline, int order, double distance) {
    for (int i = 1; i < order; ++i)
        if (!maps_to_itself(moments, outline, rotate(two_pi * i / order), distance)) return false;
    return true;
}

int rotation_order(const Moments& moments, const FineOutline& outline, double distance) {
    for (int order = most_rotations; order > 1; --order)
        if (has_order(moments, outline, order, distance)) return order;
    return 1;
}

/// An exact multiple of 15 degrees where the drawing means one.
double clean_angle(double angle) {
    constexpr double step = pi / 12;
    constexpr double rounding = 1e-9;
    const double multiple = step * std::round(angle / step);
    return std::abs(angle - multiple) < rounding ? multiple : angle;
}

Complex clean_turn(double angle) {
    constexpr double rounding = 1e-15;
    Complex turn = polar(1, angle);
    for (double* part : {&turn.x, &turn.y})
        if (std::abs(*part - std::round(*part)) < rounding) *part = std::round(*part);
    return turn;
}

/// Angles of mirror images z -> exp(i angle) conj(z) that may be symmetries, the likely ones first.
std::vector<double> mirror_candidates(const Moments& moments, const FineOutline& outline, int order, double distance) {
    std::vector<double> angles;
    for (const Alignment& mirror : alignments(moments, moments, true, hopeless_residual, most_rotations))
        angles.push_back(clean_angle(mirror.angle));
    // Beyond the orders of the moments: the farthest point goes to an equally far one, in its own sector of the rotations.
    Point far;
    for (const OutlineEdge& edge : outline.edges)
        if (norm(edge.from) > norm(far)) far = edge.from;
    for (const OutlineEdge& edge : outline.edges) {
        const double turn = wrap_angle(arg(edge.from) - arg(far));
        const bool own_sector = std::abs(turn) <= two_pi / order;
        if (order >= moment_orders && own_sector && std::abs(abs(edge.from) - abs(far)) <= distance)
            angles.push_back(clean_angle(arg(edge.from) + arg(far)));
    }
    return angles;
}

}  // namespace

bool is_circular(const Moments& moments, const FineOutline& outline, double distance) {
    for (const double angle : {0.37, 1.03, 2.41})  // radians, far from every fraction of a turn of small order
        if (!maps_to_itself(moments, outline, rotate(angle), distance)) return false;
    return true;
}

SymmetryGroup symmetry_of(const Moments& moments, const FineOutline& outline, double distance, double round_distance) {
    SymmetryGroup group;
    if (is_circular(moments, outline, round_distance)) {
        group.continuous = true;
        return group;
    }
    // Rotations.
    const int order = rotation_order(moments, outline, distance);
    for (int i = 1; i < order; ++i) group.elements.push_back({clean_turn(two_pi * i / order), {}, false});
    // Mirror images: one axis gives all.
    for (const double angle : mirror_candidates(moments, outline, order, distance)) {
        if (!within_distance(outline, {polar(1, angle), {}, true}, outline, distance)) continue;
        const double sector = two_pi / order;
        const double first = angle - sector * std::floor(angle / sector + 1e-9);  // in [0, sector), rounding forgiven
        for (int i = 0; i < order; ++i) group.elements.push_back({clean_turn(first + i * sector), {}, true});
        break;
    }
    return group;
}

}  // namespace rinceau
