// Shewchuk 1997, sections 2 and 4.3: a filter that nearly always decides, and else the determinant as an exact sum of
// doubles (an expansion), whose sign is that of its largest part. Sums of doubles must not be contracted: the whole project
// is compiled with -ffp-contract=off.

#include "geometry/orientation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

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

/// Of a point on the segment's line.
bool within_box(Point p, Point a, Point b) {
    return std::min(a.x, b.x) <= p.x && p.x <= std::max(a.x, b.x) && std::min(a.y, b.y) <= p.y && p.y <= std::max(a.y, b.y);
}

bool boxes_apart(Point a, Point b, Point c, Point d) {
    return std::max(a.x, b.x) < std::min(c.x, d.x) || std::max(c.x, d.x) < std::min(a.x, b.x) ||
           std::max(a.y, b.y) < std::min(c.y, d.y) || std::max(c.y, d.y) < std::min(a.y, b.y);
}

}  // namespace

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

SegmentContact segment_contact(Point a, Point b, Point c, Point d) {
    if (boxes_apart(a, b, c, d)) return SegmentContact::apart;
    const int of_second = orientation(a, b, c) * orientation(a, b, d);
    if (of_second > 0) return SegmentContact::apart;
    const int of_first = orientation(c, d, a) * orientation(c, d, b);
    if (of_first > 0) return SegmentContact::apart;
    if (of_second < 0 && of_first < 0) return SegmentContact::crossed;
    const auto on = [](Point p, Point from, Point to) { return orientation(from, to, p) == 0 && within_box(p, from, to); };
    const bool touch = on(c, a, b) || on(d, a, b) || on(a, c, d) || on(b, c, d);
    return touch ? SegmentContact::touching : SegmentContact::apart;
}

}  // namespace rinceau
