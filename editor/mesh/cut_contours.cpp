// Sutherland and Hodgman, "Reentrant polygon clipping", 1974, against one line.

#include "editor/mesh/cut_contours.h"

#include <utility>

namespace rinceau {
namespace {

/// On the line between two points on either side of it; the same point whichever comes first.
Point crossing(Point a, Point b, Axis axis, double at) {
    if (along(axis, b) < along(axis, a)) std::swap(a, b);
    const double share = (at - along(axis, a)) / (along(axis, b) - along(axis, a));
    const Point p = a + share * (b - a);
    return axis == Axis::x ? Point{at, p.y} : Point{p.x, at};
}

/// Between points on the line one is as good as many.
void add(std::vector<Point>& contour, Point p, Axis axis, double at) {
    const std::size_t count = contour.size();
    const auto on_line = [&](Point q) { return along(axis, q) == at; };
    if (count > 1 && on_line(p) && on_line(contour[count - 1]) && on_line(contour[count - 2])) {
        contour.back() = p;
    } else {
        contour.push_back(p);
    }
}

struct CutContour {
    std::vector<Point> low;
    std::vector<Point> high;
};

CutContour cut(const std::vector<Point>& contour, Axis axis, double at) {
    CutContour halves;
    Point from = contour.back();
    for (const Point to : contour) {
        const bool low = along(axis, to) <= at;
        const bool high = along(axis, to) >= at;
        if (((along(axis, from) < at) && !low) || ((along(axis, from) > at) && !high)) {
            const Point p = crossing(from, to, axis, at);
            add(halves.low, p, axis, at);
            add(halves.high, p, axis, at);
        }
        if (low) add(halves.low, to, axis, at);
        if (high) add(halves.high, to, axis, at);
        from = to;
    }
    return halves;
}

}  // namespace

CutContours cut(const Contours& contours, Axis axis, double at) {
    constexpr std::size_t smallest_polygon = 3;
    CutContours halves;
    for (const std::vector<Point>& contour : contours) {
        if (contour.size() < smallest_polygon) continue;
        CutContour parts = cut(contour, axis, at);
        if (parts.low.size() >= smallest_polygon) halves.low.push_back(std::move(parts.low));
        if (parts.high.size() >= smallest_polygon) halves.high.push_back(std::move(parts.high));
    }
    return halves;
}

std::size_t corner_count(const Contours& contours) {
    std::size_t count = 0;
    for (const std::vector<Point>& contour : contours) count += contour.size();
    return count;
}

}  // namespace rinceau
