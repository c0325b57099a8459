#pragma once
// Affine maps of the plane, as SVG's matrix(a b c d e f).

#include <cmath>

#include "geometry/point.h"
#include "geometry/similarity.h"

namespace rinceau {

/// (x, y) -> (a x + c y + e, b x + d y + f).
struct Affine {
    double a = 1, b = 0, c = 0, d = 1, e = 0, f = 0;

    friend constexpr bool operator==(const Affine&, const Affine&) = default;
};

constexpr Point apply(const Affine& m, Point p) { return {m.a * p.x + m.c * p.y + m.e, m.b * p.x + m.d * p.y + m.f}; }

/// First `n`, then `m`.
constexpr Affine operator*(const Affine& m, const Affine& n) {
    return {m.a * n.a + m.c * n.b, m.b * n.a + m.d * n.b,       m.a * n.c + m.c * n.d,
            m.b * n.c + m.d * n.d, m.a * n.e + m.c * n.f + m.e, m.b * n.e + m.d * n.f + m.f};
}

constexpr double determinant(const Affine& m) { return m.a * m.d - m.b * m.c; }

/// The inverse map; `m` must be invertible (determinant not 0).
constexpr Affine inverse(const Affine& m) {
    const double det = determinant(m);
    return {m.d / det, -m.b / det, -m.c / det, m.a / det, (m.c * m.f - m.d * m.e) / det, (m.b * m.e - m.a * m.f) / det};
}

constexpr Affine to_affine(const Similarity& g) {
    const double k = g.mirrored ? -1 : 1;
    return {g.linear.x, g.linear.y, -k * g.linear.y, k * g.linear.x, g.translation.x, g.translation.y};
}

}  // namespace rinceau
