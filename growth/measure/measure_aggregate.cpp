#include "growth/measure/measure_aggregate.h"

#include <algorithm>
#include <utility>

#include "growth/measure/cover.h"
#include "growth/measure/empty_circle.h"
#include "growth/measure/outline_overlaps.h"
#include "growth/measure/periodicity.h"

namespace rinceau {
namespace {

/// Of the smaller region's area: what rounding can make of regions that do not meet.
constexpr double least_shared_area = 1e-7;
constexpr double repeat_after = 1.5;  ///< largest radii of what is placed

/// Pairs that overlap, on a tile also over its edges.
std::size_t count_overlaps(const std::vector<Region>& placed, const PackDomain& domain) {
    std::vector<PlacedOutline> outlines;
    Box everything;
    for (const Region& region : placed) {
        outlines.push_back({&region, {}});
        everything = including(everything, bounds(region));
    }
    if (domain.tiled) {
        // Two that meet over an edge do so for two opposite steps: half of the steps finds all of them once.
        for (const auto& [column, row] : {std::pair{1, 0}, {-1, 1}, {0, 1}, {1, 1}}) {
            const Point step{column * width(domain.box), row * height(domain.box)};
            for (const Region& region : placed) {
                const Box box = bounds(region);
                if (overlap({box.low + step, box.high + step}, everything)) outlines.push_back({&region, translate(step)});
            }
        }
    }
    const auto pairs = overlapping_pairs(outlines, least_shared_area);
    // Two copies that are both moved meet where they stand, too.
    return static_cast<std::size_t>(std::count_if(pairs.begin(), pairs.end(), [&placed](const auto& pair) {
        return static_cast<std::size_t>(pair.first) < placed.size();
    }));
}

}  // namespace

AggregateMeasures measure_aggregate(const std::vector<ExclusiveRegion>& regions, const std::vector<PlacedRegion>& placed,
                                    const PackDomain& domain, const AggregateMeasureOptions& options) {
    AggregateMeasures measures;
    measures.placed = placed.size();
    measures.counts.resize(regions.size());
    std::vector<Region> outlines;
    double radius = 0;
    for (const PlacedRegion& one : placed) {
        const ExclusiveRegion& region = regions[static_cast<std::size_t>(one.shape)];
        measures.counts[static_cast<std::size_t>(one.shape)] += 1;
        outlines.push_back(placed_region(region.rings, one.pose));
        radius = std::max(radius, scale_of(one.pose) * region.radius);
    }
    measures.overlaps = count_overlaps(outlines, domain);
    const Cover covered = cover(outlines, domain);
    measures.area = covered.domain;
    measures.overlap_area = covered.sum - covered.united;
    measures.outside_area = covered.united - covered.within;
    measures.coverage = covered.domain > 0 ? covered.within / covered.domain : 0;
    if (options.gap) measures.largest_gap = largest_gap(outlines, domain).radius;
    if (options.gap && radius > 0) measures.largest_gap_ratio = measures.largest_gap / radius;
    if (options.autocorrelation && radius > 0)
        measures.autocorrelation = strongest_repeat(outlines, domain, repeat_after * radius).value;
    return measures;
}

}  // namespace rinceau
