#include "growth/figure_shapes.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/polygon.h"

namespace rinceau {
namespace {

bool inside_region(const Region& region, Point p) {
    bool inside = false;
    for (const auto& polygon : region) inside = inside != inside_evenodd(polygon, p);
    return inside;
}

double box_distance(const Box& box, Point p) {
    return std::hypot(std::max({box.low.x - p.x, 0.0, p.x - box.high.x}),
                      std::max({box.low.y - p.y, 0.0, p.y - box.high.y}));
}

/// From the corners of one to the edges of the other, below `within`.
double corner_gap(const Region& corners, const BoxedRegion& edges, double within) {
    for (const auto& polygon : corners)
        for (const Point p : polygon) {
            if (box_distance(edges.box, p) >= within) continue;
            if (inside_region(edges.region, p)) return 0;
            for (const auto& other : edges.region)
                for (std::size_t k = 0; k < other.size(); ++k)
                    within = std::min(within, distance_to_segment(p, other[k], other[(k + 1) % other.size()]));
        }
    return within;
}

bool edges_cross(const BoxedRegion& a, const BoxedRegion& b) {
    for (const auto& polygon : a.region)
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const Point p = polygon[k];
            const Point q = polygon[(k + 1) % polygon.size()];
            if (!overlap(including(Box{p, p}, q), b.box)) continue;
            for (const auto& other : b.region)
                for (std::size_t m = 0; m < other.size(); ++m)
                    if (segment_crossing(p, q, other[m], other[(m + 1) % other.size()])) return true;
        }
    return false;
}

double distance_to_outline(const Region& region, Point p) {
    double least = INFINITY;
    for (const auto& polygon : region)
        for (std::size_t k = 0; k < polygon.size(); ++k)
            least = std::min(least, distance_to_segment(p, polygon[k], polygon[(k + 1) % polygon.size()]));
    return least;
}

/// Points along the outline at even distances.
std::vector<Point> outline_samples(const Region& region) {
    constexpr double count = 48;
    double whole = 0;
    for (const auto& polygon : region)
        for (std::size_t k = 0; k < polygon.size(); ++k) whole += abs(polygon[(k + 1) % polygon.size()] - polygon[k]);
    const double step = whole / count;
    std::vector<Point> samples;
    double next = 0;  // from the start of the edge to the next sample
    for (const auto& polygon : region)
        for (std::size_t k = 0; k < polygon.size(); ++k) {
            const Point along = polygon[(k + 1) % polygon.size()] - polygon[k];
            const double edge = abs(along);
            if (!(step > 0)) return samples;
            for (; next < edge; next += step) samples.push_back(polygon[k] + next / edge * along);
            next -= edge;
        }
    return samples;
}

bool outline_within(const Region& a, const Region& b, double tolerance) {
    return std::ranges::all_of(a, [&](const auto& polygon) {
        return std::ranges::all_of(polygon, [&](Point p) { return distance_to_outline(b, p) <= tolerance; });
    });
}

}  // namespace

double region_gap(const BoxedRegion& a, const BoxedRegion& b, double within) {
    if (!overlap(grown(a.box, within), b.box)) return within;
    const double least = corner_gap(b.region, a, corner_gap(a.region, b, within));
    return least > 0 && overlap(a.box, b.box) && edges_cross(a, b) ? 0 : least;
}

bool lies_inside(const BoxedRegion& inner, const BoxedRegion& outer) {
    constexpr double nearly_all = 0.8;  // of the outline: hatching may stick out at both ends
    constexpr double nearly = 0.01;     // of the outer one: outlines that coincide count as inside
    const double slack = nearly * diagonal(outer.box);
    if (!contains(grown(outer.box, slack + (1 - nearly_all) * diagonal(inner.box)), inner.box)) return false;
    std::size_t outside = 0;
    const std::vector<Point> samples = outline_samples(inner.region);
    for (const Point p : samples)
        outside += !inside_region(outer.region, p) && distance_to_outline(outer.region, p) > slack ? 1 : 0;
    return static_cast<double>(outside) <= (1 - nearly_all) * static_cast<double>(samples.size());
}

bool same_outline(const Region& a, const Region& b, double tolerance) {
    return outline_within(a, b, tolerance) && outline_within(b, a, tolerance);
}

}  // namespace rinceau
