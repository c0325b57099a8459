#pragma once
// How dense and how free of period an aggregate is, in figures, by methods that its making does not use.

#include <cstddef>
#include <vector>

#include "growth/aggregate/aggregate_options.h"
#include "growth/aggregate/exclusive_region.h"
#include "growth/aggregate/pack_domain.h"

namespace rinceau {

/// Areas are scene areas; shares are of the domain's area unless said otherwise.
struct AggregateMeasures {
    std::size_t placed = 0;
    std::vector<std::size_t> counts;  ///< per shape
    std::size_t overlaps = 0;         ///< pairs of exclusive regions that share area, on a tile also over its edge
    double overlap_area = 0;          ///< sum of the areas less the area of the union
    double outside_area = 0;          ///< of regions, outside of the domain; on a tile there is no outside
    double area = 0;                  ///< of the domain
    double coverage = 0;              ///< share that the regions cover
    double largest_gap = 0;           ///< radius of the largest circle in the domain that meets no region
    double largest_gap_ratio = 0;     ///< over the largest radius R of a shape at the largest scale at which it was placed
    double autocorrelation =
        0;  ///< the highest value of the mask's autocorrelation at steps longer than 1.5 R; 1 = periodic
};

struct AggregateMeasureOptions {
    bool gap = true;              ///< measure largest_gap
    bool autocorrelation = true;  ///< measure autocorrelation
};

/// Time grows with the number of regions times its logarithm.
AggregateMeasures measure_aggregate(const std::vector<ExclusiveRegion>& regions, const std::vector<PlacedRegion>& placed,
                                    const PackDomain& domain, const AggregateMeasureOptions& options = {});

}  // namespace rinceau
