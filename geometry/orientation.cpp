// Orientation by floating-point expansions (J. R. Shewchuk, "Adaptive precision floating-point arithmetic and fast robust
// geometric predicates", 1997): the determinant as an unrounded sum of products, reached only when the filter cannot tell.

#include "geometry/orientation.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace rinceau {
namespace {

/// A sum of doubles that is kept exactly: components do not overlap and grow in size (Shewchuk, theorem 10).
struct Expansion {
    std::array<double, 12> part{};
    std::size_t count = 0;

    void add(double value) {
        for (std::size_t i = 0; i < count; ++i) {
            const double sum = value + part[i];
            const double share = sum - value;
            part[i] = (value - (sum - share)) + (part[i] - share);  // the rounding error of the sum
            value = sum;
        }
        part[count++] = value;
    }
    void add_product(double a, double b) {
        const double product = a * b;
        add(std::fma(a, b, -product));
        add(product);
    }
    int sign() const {
        for (std::size_t i = count; i-- > 0;)
            if (part[i] != 0) return part[i] > 0 ? 1 : -1;
        return 0;
    }
};

bool boxes_meet(Point a, Point b, Point c, Point d) {
    return std::max(a.x, b.x) >= std::min(c.x, d.x) && std::max(c.x, d.x) >= std::min(a.x, b.x) &&
           std::max(a.y, b.y) >= std::min(c.y, d.y) && std::max(c.y, d.y) >= std::min(a.y, b.y);
}

}  // namespace

int exact_orientation(Point a, Point b, Point c) {
    // (a - c) x (b - c) without differences, which would round; c x c is zero.
    Expansion turn;
    turn.add_product(a.x, b.y);
    turn.add_product(-a.x, c.y);
    turn.add_product(-c.x, b.y);
    turn.add_product(-a.y, b.x);
    turn.add_product(a.y, c.x);
    turn.add_product(c.y, b.x);
    return turn.sign();
}

bool segments_meet(Point a, Point b, Point c, Point d) {
    if (!boxes_meet(a, b, c, d)) return false;
    const int side_c = orientation(a, b, c), side_d = orientation(a, b, d);
    if (side_c * side_d > 0) return false;
    const int side_a = orientation(c, d, a), side_b = orientation(c, d, b);
    // On one line, or one of them a point on the other's line: their boxes meet, and so do they.
    return side_a * side_b <= 0;
}

}  // namespace rinceau
