#include "analyzer/moments.h"

#include <algorithm>
#include <cmath>

namespace rinceau {

namespace {

constexpr int cubic_parts = 3;  // of 8 quadrature points each: arc length of ordinary curves to 1e-9

/// Gauss-Legendre with 8 points is exact on a line up to degree 15, the highest that carries weight in an alignment.
std::vector<ArcSample> arc_samples_of(const OutlinePiece& piece) {
    if (!piece.straight) return arc_samples(piece.curve, cubic_parts);
    const Point a = piece.curve.from;
    const Point b = piece.curve.to;
    return arc_samples({a, a + (b - a) / 3, b - (b - a) / 3, b}, 1);
}

Moments moments_of(const std::vector<ArcSample>& samples, Point centroid, double rms_radius, double length) {
    Moments moments;
    for (const ArcSample& sample : samples) {
        const Complex w = (sample.at - centroid) / rms_radius;
        const double squared = norm(w);
        Complex power{sample.weight / length, 0};
        for (int k = 0; k < moment_orders; ++k) {
            Complex term = power;
            for (int q = 0; q < moment_powers; ++q) {
                moments.value[static_cast<std::size_t>(q)][static_cast<std::size_t>(k)] += term;
                term = squared * term;
            }
            power = power * w;
        }
    }
    return moments;
}

InvariantKey key_of(const Moments& moments, double length_in_radii) {
    const auto& m = moments.value;
    return {std::log(length_in_radii), abs(m[0][2]),       abs(m[0][3]) / 2,   abs(m[1][1]) / 2,
            0.3 * abs(m[2][0]),        0.3 * abs(m[1][2]), 0.3 * abs(m[0][4]), 0.2 * abs(m[2][1])};
}

}  // namespace

Descriptor describe(const Outline& outline) {
    std::vector<ArcSample> samples;
    for (const OutlinePiece& piece : outline.pieces) {
        const std::vector<ArcSample> part = arc_samples_of(piece);
        samples.insert(samples.end(), part.begin(), part.end());
    }
    Descriptor result;
    result.centroid = outline.origin;
    Point first_moment;
    for (const ArcSample& sample : samples) {
        result.length += sample.weight;
        first_moment += sample.weight * sample.at;
    }
    if (!(result.length > 0)) return result;
    const Point centroid = first_moment / result.length;
    double spread = 0;
    for (const ArcSample& sample : samples) spread += sample.weight * norm(sample.at - centroid);
    result.centroid = outline.origin + centroid;
    result.rms_radius = std::sqrt(spread / result.length);
    if (!(result.rms_radius > 0)) return result;
    result.moments = moments_of(samples, centroid, result.rms_radius, result.length);
    result.key = key_of(result.moments, result.length / result.rms_radius);
    return result;
}

double key_distance(const InvariantKey& a, const InvariantKey& b) {
    double distance = 0;
    for (std::size_t i = 0; i < a.size(); ++i) distance = std::max(distance, std::abs(a[i] - b[i]));
    return distance;
}

}  // namespace rinceau
