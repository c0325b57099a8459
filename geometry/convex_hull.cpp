#include "geometry/convex_hull.h"

#include <algorithm>
#include <utility>

#include "geometry/orientation.h"

namespace rinceau {
namespace {

/// The lower chain from the first to the last of sorted points; from the last to the first, the upper one.
void append_chain(std::vector<Point>& hull, std::span<const Point> sorted) {
    const std::size_t start = hull.size();
    for (const Point p : sorted) {
        while (hull.size() >= start + 2 && orientation(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
        hull.push_back(p);
    }
    hull.pop_back();  // the other chain begins with it
}

}  // namespace

std::vector<Point> convex_hull(std::span<const Point> points) {
    std::vector<Point> sorted(points.begin(), points.end());
    std::ranges::sort(sorted, {}, [](Point p) { return std::pair(p.x, p.y); });
    sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
    if (sorted.size() < 3) return sorted;
    std::vector<Point> hull;
    append_chain(hull, sorted);
    std::ranges::reverse(sorted);
    append_chain(hull, sorted);
    return hull;
}

}  // namespace rinceau
