#include "growth/arrangement/ring_likeness.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rinceau {
namespace {

std::vector<Point> offsets_of(std::span<const Point> points, const Connectivity& connectivity, std::size_t point) {
    std::vector<Point> offsets;
    for (const int other : connectivity.rings[point])
        offsets.push_back(points[static_cast<std::size_t>(other)] - points[point]);
    return offsets;
}

/// Mean square of the distances between places, in the cyclic order that fits best.
double difference(const std::vector<Point>& a, const std::vector<Point>& b) {
    if (a.size() != b.size()) return std::numeric_limits<double>::infinity();
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t shift = 0; shift < a.size(); ++shift) {
        double sum = 0;
        for (std::size_t k = 0; k < a.size(); ++k) sum += norm(a[k] - b[(k + shift) % b.size()]);
        least = std::min(least, sum / static_cast<double>(a.size()));
    }
    return least;
}

}  // namespace

double alike_rings(std::span<const Point> points, const Connectivity& connectivity) {
    constexpr double alike = 0.25;               // of the spacing
    constexpr std::size_t most_compared = 1000;  // points; more tell nothing new
    constexpr std::ptrdiff_t few = 5;
    const std::vector<bool>& whole =
        std::ranges::count(connectivity.deep, true) < few ? connectivity.inner : connectivity.deep;
    std::vector<std::vector<Point>> rings;
    for (std::size_t p = 0; p < points.size() && rings.size() < most_compared; ++p)
        if (whole[p]) rings.push_back(offsets_of(points, connectivity, p));
    if (rings.empty()) return 0;
    const double limit = alike * alike * connectivity.spacing * connectivity.spacing;
    const std::size_t wanted = std::max<std::size_t>(3, rings.size() / 5);
    std::size_t met_again = 0;
    for (std::size_t i = 0; i < rings.size(); ++i) {
        std::size_t same = 0;
        for (std::size_t j = 0; j < rings.size() && same < wanted; ++j)
            same += i != j && difference(rings[i], rings[j]) <= limit ? 1 : 0;
        met_again += same >= wanted ? 1 : 0;
    }
    return static_cast<double>(met_again) / static_cast<double>(rings.size());
}

}  // namespace rinceau
