#pragma once
// Similarities of the plane: move, turn, scale evenly, mirror.

#include "geometry/angle.h"
#include "geometry/point.h"

namespace rinceau {

/// z -> linear * (mirrored ? conj(z) : z) + translation.  `linear` must not be zero.
struct Similarity {
    Complex linear{1, 0};
    Point translation{};
    bool mirrored = false;

    friend constexpr bool operator==(const Similarity&, const Similarity&) = default;
};

constexpr Complex flipped_if(bool mirrored, Complex z) { return mirrored ? conj(z) : z; }

constexpr Point apply(const Similarity& g, Point z) { return g.linear * flipped_if(g.mirrored, z) + g.translation; }

/// First `h`, then `g`.
constexpr Similarity operator*(const Similarity& g, const Similarity& h) {
    return {g.linear * flipped_if(g.mirrored, h.linear), apply(g, h.translation), g.mirrored != h.mirrored};
}

constexpr Similarity inverse(const Similarity& g) {
    const Complex inverse_linear = flipped_if(g.mirrored, Complex{1, 0} / g.linear);
    return {inverse_linear, -(inverse_linear * flipped_if(g.mirrored, g.translation)), g.mirrored};
}

inline double scale_of(const Similarity& g) { return abs(g.linear); }

constexpr Similarity translate(Point by) { return {{1, 0}, by, false}; }
inline Similarity rotate(double angle) { return {polar(1, angle), {}, false}; }
constexpr Similarity scale_by(double factor) { return {{factor, 0}, {}, false}; }
/// Mirror image about the y axis, the turtle's heading: x -> -x.
constexpr Similarity mirror_about_heading() { return {{-1, 0}, {}, true}; }

}  // namespace rinceau
