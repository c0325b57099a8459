// Shewchuk 1997, sections 2 and 4.3: a filter that nearly always decides, and else the determinant as an exact sum of
// doubles (an expansion), whose sign is that of its largest part. Sums of doubles must not be contracted: the whole project
// is compiled with -ffp-contract=off.

#include "geometry/orientation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace rinceau {
namespace {

/// A sum of doubles that do not overlap, smallest first, without any rounding.
class ExactSum {
  public:
    void add(double value) {
        double carried = value;
        for (std::size_t i = 0; i < count_; ++i) {
            const double sum = carried + parts_[i];
            const double of_part = sum - carried;
            const double lost = (carried - (sum - of_part)) + (parts_[i] - of_part);
            parts_[i] = lost;
            carried = sum;
        }
        parts_[count_++] = carried;
    }
    void add_product(double x, double y) {
        const double product = x * y;
        add(std::fma(x, y, -product));
        add(product);
    }
    int sign() const {
        for (std::size_t i = count_; i-- > 0;) {
            if (parts_[i] != 0) return parts_[i] > 0 ? 1 : -1;
        }
        return 0;
    }

  private:
    static constexpr std::size_t most_parts = 12;  // six products
    std::array<double, most_parts> parts_{};
    std::size_t count_ = 0;
};

int exact_orientation(Point a, Point b, Point c) {
    ExactSum determinant;
    determinant.add_product(a.x, b.y);
    determinant.add_product(-a.x, c.y);
    determinant.add_product(-c.x, b.y);
    determinant.add_product(-a.y, b.x);
    determinant.add_product(a.y, c.x);
    determinant.add_product(c.y, b.x);
    return determinant.sign();
}

/// Of a point on the segment's line.
bool within_box(Point p, Point a, Point b) {
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

bool boxes_apart(Point a1, Point a2, Point b1, Point b2) {
    return std::max(a1.x, a2.x) < std::min(b1.x, b2.x) || std::max(b1.x, b2.x) < std::min(a1.x, a2.x) ||
           std::max(a1.y, a2.y) < std::min(b1.y, b2.y) || std::max(b1.y, b2.y) < std::min(a1.y, a2.y);
}

}  // namespace

int orientation(Point a, Point b, Point c) {
    const double left = (a.x - c.x) * (b.y - c.y);
    const double right = (a.y - c.y) * (b.x - c.x);
    const double determinant = left - right;
    // The bound "ccwerrboundA" of the paper's section 4.3, for half a unit in the last place.
    constexpr double half_ulp = std::numeric_limits<double>::epsilon() / 2;
    constexpr double bound = (3 + 16 * half_ulp) * half_ulp;
    if (std::abs(determinant) > bound * (std::abs(left) + std::abs(right))) return determinant > 0 ? 1 : -1;
    return exact_orientation(a, b, c);
}

SegmentContact segment_contact(Point a1, Point a2, Point b1, Point b2) {
    if (boxes_apart(a1, a2, b1, b2)) return SegmentContact::apart;
    const int from_a = orientation(a1, a2, b1) * orientation(a1, a2, b2);
    if (from_a > 0) return SegmentContact::apart;
    const int from_b = orientation(b1, b2, a1) * orientation(b1, b2, a2);
    if (from_b > 0) return SegmentContact::apart;
    if (from_a < 0 && from_b < 0) return SegmentContact::crossed;
    const auto on = [](Point p, Point a, Point b) { return orientation(a, b, p) == 0 && within_box(p, a, b); };
    const bool touch = on(b1, a1, a2) || on(b2, a1, a2) || on(a1, b1, b2) || on(a2, b1, b2);
    return touch ? SegmentContact::touching : SegmentContact::apart;
}

}  // namespace rinceau
