#pragma once
// Shapes to pack, and a measure of what overlaps that does not use the packing's own test.

#include <vector>

#include "growth/aggregate/aggregate_options.h"
#include "growth/aggregate/exclusive_region.h"

namespace rinceau {

inline std::vector<Point> box_ring(double x, double y, double w, double h) {
    return {{x, y}, {x + w, y}, {x + w, y + h}, {x, y + h}};
}

/// A star, a long bar and a bow that others can reach into.
inline std::vector<ExclusiveRegion> star_bar_and_bow() {
    std::vector<Point> star, bow;
    for (int i = 0; i < 10; ++i) star.push_back(polar(i % 2 == 0 ? 20 : 9, two_pi * i / 10));
    for (int i = 0; i <= 12; ++i) bow.push_back(polar(22, 1.3 * pi * i / 12));
    for (int i = 12; i >= 0; --i) bow.push_back(polar(15, 1.3 * pi * i / 12));
    return {exclusive_region({star}, {}, "star"), exclusive_region({box_ring(0, 0, 50, 9)}, {}, "bar"),
            exclusive_region({bow}, {}, "bow")};
}

inline Region outline_of(const std::vector<ExclusiveRegion>& regions, const PlacedRegion& placed, Point shift = {}) {
    Region outline = regions[static_cast<std::size_t>(placed.shape)].rings;
    for (auto& ring : outline)
        for (Point& p : ring) p = apply(placed.pose, p) + shift;
    return outline;
}

/// Area that more than one of the regions covers, as Clipper finds it while it unites them two by two.
inline double area_covered_twice(std::vector<Region> regions) {
    double twice = 0;
    while (regions.size() > 1) {
        std::vector<Region> united;
        for (std::size_t i = 0; i + 1 < regions.size(); i += 2) {
            twice += area(intersection_of(regions[i], regions[i + 1]));
            united.push_back(union_of(regions[i], regions[i + 1]));
        }
        if (regions.size() % 2 == 1) united.push_back(regions.back());
        regions = std::move(united);
    }
    return twice;
}

inline double covered_area(const std::vector<ExclusiveRegion>& regions, const std::vector<PlacedRegion>& placed) {
    double sum = 0;
    for (const PlacedRegion& region : placed)
        sum += regions[static_cast<std::size_t>(region.shape)].area * norm(region.pose.linear);
    return sum;
}

}  // namespace rinceau
