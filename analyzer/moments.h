#pragma once
// Moments of the arc-length measure of an outline (docs/analysis.md, 1). They know nothing of nodes, start points,
// directions and sub-paths; a rotation by t multiplies moment k by exp(ikt), a mirror image conjugates, and all else
// leaves them alone.

#include <array>

#include "analyzer/outline.h"

namespace rinceau {

constexpr int moment_orders = 13;  ///< k = 0 .. 12
constexpr int moment_powers = 3;   ///< q = 0 .. 2

/// value[q][k] = mean over the arc length of w^k |w|^(2q), w = (z - centroid) / rms radius.
struct Moments {
    std::array<std::array<Complex, moment_orders>, moment_powers> value{};
};

/// Numbers that no similarity changes, scaled so that 0.01 means about one per cent of the size.
using InvariantKey = std::array<double, 8>;

struct Descriptor {
    Point centroid;         ///< of the arc-length measure, scene space
    double rms_radius = 0;  ///< root mean square distance from the centroid; 0 for an outline without length
    double length = 0;      ///< scene lengths
    Moments moments;        ///< all 0 for rms_radius 0
    InvariantKey key{};
};

Descriptor describe(const Outline& outline);

double key_distance(const InvariantKey& a, const InvariantKey& b);  ///< maximum norm

}  // namespace rinceau
