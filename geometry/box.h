#pragma once
// An axis-parallel box; a default box is empty and grows by what is added.

#include <algorithm>
#include <limits>

#include "geometry/point.h"

namespace rinceau {

struct Box {
    Point low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    Point high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

    friend constexpr bool operator==(const Box&, const Box&) = default;
};

constexpr bool is_empty(const Box& box) { return !(box.low.x <= box.high.x && box.low.y <= box.high.y); }
constexpr double width(const Box& box) { return is_empty(box) ? 0 : box.high.x - box.low.x; }
constexpr double height(const Box& box) { return is_empty(box) ? 0 : box.high.y - box.low.y; }
constexpr Point center(const Box& box) { return 0.5 * (box.low + box.high); }
inline double diagonal(const Box& box) { return std::hypot(width(box), height(box)); }

constexpr Box including(Box box, Point p) {
    return {{std::min(box.low.x, p.x), std::min(box.low.y, p.y)}, {std::max(box.high.x, p.x), std::max(box.high.y, p.y)}};
}
constexpr Box including(Box box, const Box& other) {
    return is_empty(other) ? box : including(including(box, other.low), other.high);
}
/// The box grown by `margin` on every side; an empty box stays empty.
constexpr Box grown(const Box& box, double margin) {
    return is_empty(box) ? box : Box{{box.low.x - margin, box.low.y - margin}, {box.high.x + margin, box.high.y + margin}};
}
constexpr bool overlap(const Box& a, const Box& b) {
    return !is_empty(a) && !is_empty(b) && a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y &&
           b.low.y <= a.high.y;
}
constexpr bool contains(const Box& outer, const Box& inner) {
    return is_empty(inner) || (outer.low.x <= inner.low.x && outer.low.y <= inner.low.y && inner.high.x <= outer.high.x &&
                               inner.high.y <= outer.high.y);
}

}  // namespace rinceau
