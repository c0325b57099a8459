#pragma once
// How an aggregate is filled: the choices that a user has (Sakurai & Miyata 2014, sections 3.2 and 4; docs/growth.md).

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "geometry/similarity.h"
#include "growth/aggregate/pack_domain.h"
#include "growth/flow_field.h"

namespace rinceau {

/// darts: section 3.2. gaps: section 4. settle: candidates as in gaps, slid and turned into their gap before they are tried.
enum class PackMethod : std::uint8_t { naive, gaps, settle };

/// best: shapes also grow to the largest scale that fits, and all is shaken and filled again.
enum class PackQuality : std::uint8_t { fast, best };

/// Which angles a shape may have, radians.
struct PackAngles {
    std::vector<double> only;               ///< these alone; empty = from low to high
    double low = 0, high = two_pi;
    std::shared_ptr<const FlowField> flow;  ///< angles are measured from its direction; null = from +x
};

struct AggregateOptions {
    PackMethod method = PackMethod::settle;
    PackQuality quality = PackQuality::fast;
    double min_scale = 1, max_scale = 1;
    PackAngles angles;
    std::vector<double> shares;         ///< of the shapes among what is placed; empty = equal
    double share_tolerance = 0.1;       ///< how far a share may be missed so that filling can go on; 0 = strictly in turn, 1 = whatever fits
    std::shared_ptr<const DensityPicture> density;  ///< null = everywhere alike
    std::size_t stop = 0;               ///< cancellations in a row that end it; 0 = the method's own (10,000; 200; 1,000 or as many as are placed, of best 300 or a quarter of them)
    std::size_t max_count = 1'000'000;  ///< of shapes
    int shakes = 6;                     ///< rounds of quality best
    std::uint64_t seed = 1;
};

struct PlacedRegion {
    int shape = 0;
    Similarity pose;  ///< frame of the exclusive region -> scene
};

struct AggregateCounts {
    std::size_t attempted = 0;  ///< placements tried
    std::size_t tested = 0;     ///< of them, by the exact test
    std::size_t cancelled = 0;
};

struct Aggregate {
    std::vector<PlacedRegion> placed;
    AggregateCounts counts;
    bool complete = true;  ///< false: it was stopped before the method's own end
};

}  // namespace rinceau
