#pragma once
// The colour that a paint has at a point, and colours on top of each other.

#include <algorithm>
#include <cmath>

#include "scene/style.h"

namespace rinceau {

/// sRGB colour times opacity, and opacity, all 0..1; nothing painted = all 0.
struct Ink {
    double red = 0, green = 0, blue = 0, alpha = 0;
    friend constexpr bool operator==(const Ink&, const Ink&) = default;
};

constexpr Ink operator+(const Ink& a, const Ink& b) {
    return {a.red + b.red, a.green + b.green, a.blue + b.blue, a.alpha + b.alpha};
}
constexpr Ink operator*(double k, const Ink& a) { return {k * a.red, k * a.green, k * a.blue, k * a.alpha}; }

/// `upper` painted on `lower` (source over).
constexpr Ink over(const Ink& upper, const Ink& lower) { return upper + (1 - upper.alpha) * lower; }

/// The largest difference in a channel, 0..1, on whatever ground both are painted.
inline double difference(const Ink& a, const Ink& b) {
    const double ground = b.alpha - a.alpha;  // how much more of a white ground shows through a; a black one adds nothing
    const auto channel = [&](double d) { return std::max(std::abs(d), std::abs(d + ground)); };
    return std::max({channel(a.red - b.red), channel(a.green - b.green), channel(a.blue - b.blue)});
}

/// A paint made ready for many points.
struct PaintSampler {
    const Gradient* gradient = nullptr;  ///< nothing: `solid` everywhere
    Affine to_unit;                      ///< into the frame of the unit gradient
    Ink solid;
    double opacity = 1;  ///< of the gradient's colours
};

/// The gradient is not copied: `paint` must live on.
PaintSampler paint_sampler(const Paint& paint, double opacity);

Ink paint_at(const PaintSampler& sampler, Point p);

}  // namespace rinceau
